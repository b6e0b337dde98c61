#pragma once

#include <cstddef>
#include <cstdint>
#include <list>
#include <memory>
#include <type_traits>
#include <utility>

#include "render/gl/errors.h"

namespace crest {

/// Values of any type, held by what they were made of: the same key is never made twice while its value is
/// held. Keys compare with ==; a value's type belongs to its key's type. A key with a member is_stale() is
/// dropped when that is true. Holds few entries: each is looked at in turn.
class KeyedCache {
 public:
  /// What was used in so many rounds before the current one stays, whatever it takes: views that are drawn in
  /// turn must not drive out each other's.
  static constexpr std::uint64_t kept_rounds = 32;

  /// Above one of these the values that were used longest ago go, but for those of the last rounds.
  explicit KeyedCache(std::size_t limit_bytes, std::size_t limit_count = 64)
      : limit_bytes_(limit_bytes), limit_count_(limit_count) {}

  /// What is asked for from now on is not dropped before the next call.
  void begin_round() {
    ++round_;
    drop_while([](const Entry& e) { return e.is_stale(); }, [] { return true; });
  }

  /// The key's value: make(), which takes `bytes`, where none is held. It stays where it is for this round.
  /// If make() throws gl::NoRoom, all that this round has not used is dropped, and it may try once more.
  template <class Key, class Make>
  const std::invoke_result_t<Make>& get(const Key& key, std::size_t bytes, const Make& make) {
    using Value = std::invoke_result_t<Make>;
    for (auto entry = entries_.begin(); entry != entries_.end(); ++entry) {
      auto* found = dynamic_cast<Held<Key, Value>*>(entry->get());
      if (!found || !(found->key == key)) continue;
      found->round = round_;
      entries_.splice(entries_.begin(), entries_, entry);
      return found->value;
    }
    drop_while([&](const Entry& e) { return e.round + kept_rounds < round_; },
               [&] { return bytes_ + bytes > limit_bytes_ || entries_.size() >= limit_count_; });
    entries_.push_front(std::make_unique<Held<Key, Value>>(key, with_room(make)));
    Entry& entry = *entries_.front();
    entry.bytes = bytes;
    entry.round = round_;
    bytes_ += bytes;
    ++made_;
    return static_cast<Held<Key, Value>&>(entry).value;
  }

  /// Calls make(). If it throws gl::NoRoom, all that this round has not used is dropped, and it may try once
  /// more.
  template <class Make>
  std::invoke_result_t<Make> with_room(const Make& make) {
    try {
      return make();
    } catch (const gl::NoRoom&) {
      const std::size_t before = entries_.size();
      drop_while([&](const Entry& e) { return e.round != round_; }, [] { return true; });
      if (entries_.size() == before) throw;
      return make();
    }
  }

  /// What a held value, which has grown since it was made, takes now.
  template <class Value, class Key>
  void recount(const Key& key, std::size_t bytes) {
    for (const auto& entry : entries_) {
      const auto* found = dynamic_cast<const Held<Key, Value>*>(entry.get());
      if (!found || !(found->key == key)) continue;
      bytes_ += bytes - entry->bytes;
      entry->bytes = bytes;
    }
  }

  /// Lets all go.
  void clear() {
    entries_.clear();
    bytes_ = 0;
  }

  std::size_t bytes() const { return bytes_; }
  std::size_t count() const { return entries_.size(); }
  int made() const { return made_; }  ///< values in all, since the beginning

 private:
  struct Entry {
    virtual ~Entry() = default;
    virtual bool is_stale() const = 0;
    std::size_t bytes = 0;
    std::uint64_t round = 0;  ///< in which it was last asked for
  };
  template <class Key, class Value>
  struct Held : Entry {
    Held(Key k, Value v) : key(std::move(k)), value(std::move(v)) {}
    bool is_stale() const override {
      if constexpr (requires { key.is_stale(); })
        return key.is_stale();
      else
        return false;
    }
    Key key;
    Value value;
  };

  /// Of the entries that `may_go`, from the one that was used longest ago.
  template <class MayGo, class While>
  void drop_while(const MayGo& may_go, const While& goes_on) {
    for (auto entry = entries_.end(); entry != entries_.begin() && goes_on();) {
      --entry;
      if (!may_go(**entry)) continue;
      bytes_ -= (*entry)->bytes;
      entry = entries_.erase(entry);
    }
  }

  std::list<std::unique_ptr<Entry>> entries_;  ///< the last used first
  std::size_t limit_bytes_, limit_count_, bytes_ = 0;
  std::uint64_t round_ = 0;
  int made_ = 0;
};

}  // namespace crest
