#pragma once

#include <random>
#include <string>
#include <vector>

namespace crest::fuzz {

/// One of the seeds with one change or several: bytes and bits, parts cut out, doubled, put elsewhere or
/// taken from another seed, words and numbers replaced. The same on all machines for the same state of
/// `random`.
std::string mutated(const std::vector<std::string>& seeds, const std::vector<std::string>& words,
                    std::mt19937& random);

}  // namespace crest::fuzz
