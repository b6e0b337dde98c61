#pragma once

#include <nlohmann/json.hpp>

// Compiled once (json.cpp), not in each file that uses them.
extern template class nlohmann::basic_json<>;
extern template class nlohmann::basic_json<nlohmann::ordered_map>;
