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

/// So many rounds that what was used before them may go.
void let_pass(KeyedCache& cache) {
  for (std::uint64_t i = 0; i <= KeyedCache::kept_rounds; ++i) cache.begin_round();
}

TEST(KeyedCache, DropsWhatWasUsedLongestAgo) {
  KeyedCache cache(2 * kilobyte);
  for (const int number : {1, 2, 1, 3, 1}) {  // 3 takes the place of 2, not of 1
    let_pass(cache);
    get(cache, number);
  }
  EXPECT_EQ(cache.made(), 3);
  EXPECT_EQ(cache.bytes(), 2 * kilobyte);
  let_pass(cache);
  get(cache, 2);
  EXPECT_EQ(cache.made(), 4);
}

// Small values may not fill the list, however little they take.
TEST(KeyedCache, HoldsFewEntries) {
  KeyedCache cache(1000 * kilobyte, 3);
  for (int number = 0; number < 10; ++number) {
    let_pass(cache);
    get(cache, number);
  }
  EXPECT_EQ(cache.count(), 3u);
}

// Pictures that are drawn in turn take more than the limit together: none drives out what the others use.
TEST(KeyedCache, KeepsWhatTheLastRoundsUse) {
  KeyedCache cache(2 * kilobyte, 2);
  for (int frame = 0; frame < 3; ++frame)
    for (int view = 0; view < 4; ++view) {
      cache.begin_round();
      get(cache, 10 + view);
      get(cache, 1);  // the volume, say, is asked for after what is small
    }
  EXPECT_EQ(cache.made(), 5);
}

// What a picture is drawn with stays, even where that is more than the limit.
TEST(KeyedCache, KeepsWhatThisRoundUses) {
  KeyedCache cache(2 * kilobyte);
  cache.begin_round();
  for (const int number : {1, 2, 3, 4, 1, 2, 3, 4}) get(cache, number);
  EXPECT_EQ(cache.made(), 4);
  EXPECT_EQ(cache.count(), 4u);
  let_pass(cache);
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
    if (++tries == 1) throw gl::NoRoom("no room");
    return 7;
  };
  EXPECT_EQ(cache.get(OtherKey{1}, kilobyte, tight), 7);
  EXPECT_EQ(cache.count(), 1u);
  const auto never = []() -> int { throw gl::NoRoom("no room"); };
  EXPECT_THROW(cache.get(OtherKey{2}, kilobyte, never), gl::NoRoom);
  EXPECT_EQ(cache.bytes(), kilobyte);
}

// What room cannot mend takes nothing from the others.
TEST(KeyedCache, OtherErrorsDropNothing) {
  KeyedCache cache(10 * kilobyte);
  get(cache, 1);
  cache.begin_round();
  const auto wrong = []() -> int { throw Error("too many points"); };
  EXPECT_THROW(cache.get(OtherKey{1}, kilobyte, wrong), Error);
  EXPECT_EQ(cache.count(), 1u);
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
