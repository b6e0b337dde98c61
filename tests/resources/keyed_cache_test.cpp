#include "render/resources/keyed_cache.h"

#include <gtest/gtest.h>

#include <string>

namespace crest {
namespace {

struct NumberKey {
  int number;
  bool operator==(const NumberKey&) const = default;
};
struct OtherKey {
  int number;
  bool operator==(const OtherKey&) const = default;
};
struct OwnedKey {
  std::weak_ptr<int> owner;
  bool operator==(const OwnedKey& other) const { return owner.lock() == other.owner.lock(); }
  bool is_stale() const { return owner.expired(); }
};

constexpr std::size_t kilobyte = 1000;

std::string get(KeyedCache& cache, int number) {
  return cache.get(NumberKey{number}, kilobyte, [&] { return std::to_string(number); });
}

TEST(KeyedCache, MakesEachKeyOnce) {
  KeyedCache cache(10 * kilobyte);
  for (int round = 0; round < 3; ++round) {
    cache.begin_round();
    for (const int number : {1, 2, 1}) EXPECT_EQ(get(cache, number), std::to_string(number));
    EXPECT_EQ(cache.get(OtherKey{1}, kilobyte, [] { return 2.5; }), 2.5);
  }
  EXPECT_EQ(cache.made(), 3);
  EXPECT_EQ(cache.bytes(), 3 * kilobyte);
}

TEST(KeyedCache, DropsWhatWasUsedLongestAgo) {
  KeyedCache cache(2 * kilobyte);
  for (const int number : {1, 2, 1, 3, 1}) {  // 3 takes the place of 2, not of 1
    cache.begin_round();
    get(cache, number);
  }
  EXPECT_EQ(cache.made(), 3);
  EXPECT_EQ(cache.bytes(), 2 * kilobyte);
  cache.begin_round();
  get(cache, 2);
  EXPECT_EQ(cache.made(), 4);
}

// What a picture is drawn with stays, even where that is more than the limit.
TEST(KeyedCache, KeepsWhatThisRoundUses) {
  KeyedCache cache(2 * kilobyte);
  cache.begin_round();
  for (const int number : {1, 2, 3, 4, 1, 2, 3, 4}) get(cache, number);
  EXPECT_EQ(cache.made(), 4);
  EXPECT_EQ(cache.count(), 4u);
  cache.begin_round();
  get(cache, 5);
  EXPECT_EQ(cache.bytes(), 2 * kilobyte);
}

TEST(KeyedCache, DropsWhatNobodyOwns) {
  KeyedCache cache(10 * kilobyte);
  auto owner = std::make_shared<int>(1);
  cache.get(OwnedKey{owner}, kilobyte, [] { return 1; });
  cache.begin_round();
  EXPECT_EQ(cache.count(), 1u);
  owner.reset();
  cache.begin_round();
  EXPECT_EQ(cache.count(), 0u);
  EXPECT_EQ(cache.bytes(), 0u);
}

// A driver that has no room has some once the rest is gone.
TEST(KeyedCache, TriesAgainWithoutTheRest) {
  KeyedCache cache(10 * kilobyte);
  get(cache, 1);
  cache.begin_round();
  int tries = 0;
  const auto tight = [&] {
    if (++tries == 1) throw Error("no room");
    return 7;
  };
  EXPECT_EQ(cache.get(OtherKey{1}, kilobyte, tight), 7);
  EXPECT_EQ(cache.count(), 1u);
  const auto never = []() -> int { throw Error("no room"); };
  EXPECT_THROW(cache.get(OtherKey{2}, kilobyte, never), Error);
  EXPECT_EQ(cache.bytes(), kilobyte);
}

// A value may be made of others that are held.
TEST(KeyedCache, ValuesAreMadeOfValues) {
  KeyedCache cache(kilobyte);
  cache.begin_round();
  const auto make = [&] { return get(cache, 1) + get(cache, 2); };
  EXPECT_EQ(cache.get(OtherKey{1}, kilobyte, make), "12");
  EXPECT_EQ(cache.made(), 3);
}

}  // namespace
}  // namespace crest
