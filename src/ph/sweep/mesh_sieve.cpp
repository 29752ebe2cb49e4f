#include "phrame/ph/sweep/mesh_sieve.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

#include "phrame/ph/sweep/mesh_numbers.hpp"

namespace phrame::inline v0 {
namespace {

constexpr std::size_t triangles_at_once = 1U << 15;
constexpr std::uint64_t points_at_once = 1U << 20;

/// The same for the same point, 0 and −0 being one; never 0.
std::uint64_t hash_of(const Vector<double>& point) {
  std::uint64_t hash = 0;
  for (const double x : point) {
    hash ^= std::bit_cast<std::uint64_t>(x + 0.0);
    // Steele, Lea and Flood, "Fast splittable pseudorandom number generators" [2014].
    hash += 0x9e3779b97f4a7c15;
    hash = (hash ^ (hash >> 30)) * 0xbf58476d1ce4e5b9;
    hash = (hash ^ (hash >> 27)) * 0x94d049bb133111eb;
    hash ^= hash >> 31;
  }
  return std::max(hash, std::uint64_t{1});
}

/// Numbers that are not 0, to be told apart.
class HashTable {
 public:
  HashTable() : slots_(2 * points_at_once) {}
  void clear() { std::fill(slots_.begin(), slots_.end(), 0); }
  /// False where it is there, or there is no room.
  bool add(std::uint64_t hash) {
    std::size_t at = hash % slots_.size();
    for (std::size_t tried = 0; tried < slots_.size(); ++tried, at = (at + 1) % slots_.size()) {
      if (slots_[at] == hash) return false;
      if (slots_[at] != 0) continue;
      slots_[at] = hash;
      return true;
    }
    return false;
  }

 private:
  std::vector<std::uint64_t> slots_;
};

}  // namespace

MeshSieve::MeshSieve(Coordinates numbers, MeshSink& out)
    : greatest_(greatest_coordinate(numbers)), out_(out) {}

void MeshSieve::add_point(const Vector<double>& point) {
  for (const double x : point) is_sound_ = is_sound_ && std::abs(x) < greatest_;
  hashes_.append([hash = hash_of(point)](std::string& bytes) {
    bytes.append(reinterpret_cast<const char*>(&hash), sizeof hash);
  });
  ++points_;
  out_.add_point(point);
}

void MeshSieve::add_triangle(const Triangle& triangle, const Corners& corners) {
  is_sound_ = is_sound_ && has_area(*corners[0], *corners[1], *corners[2]);
  last_.push_back(triangle);
  out_.add_triangle(triangle, corners);
}

void MeshSieve::keep_points(std::span<const std::uint32_t> some,
                            std::span<const std::uint32_t> others) {
  if (last_.size() < triangles_at_once) return;
  std::vector<std::uint32_t> kept(some.begin(), some.end());
  kept.insert(kept.end(), others.begin(), others.end());
  std::sort(kept.begin(), kept.end());
  kept.erase(std::unique(kept.begin(), kept.end()), kept.end());
  look_at_sides(std::move(kept));
}

/// Its place among those that triangles may have: the kept ones, and behind them the new ones.
std::optional<std::uint32_t> MeshSieve::place_of(std::uint32_t point) const {
  const auto kept = static_cast<std::uint32_t>(kept_.size());
  if (point >= first_)
    return point < points_ ? std::optional(kept + (point - first_)) : std::nullopt;
  const auto found = std::lower_bound(kept_.begin(), kept_.end(), point);
  if (found == kept_.end() || *found != point) return std::nullopt;
  return static_cast<std::uint32_t>(found - kept_.begin());
}

// No later triangle has a point but the kept ones and new ones, or it is not proved. So a side one
// of whose ends is not kept is not there again, nor is its opposite: both are looked at now.
void MeshSieve::look_at_sides(std::vector<std::uint32_t> kept) {
  const auto replace = [this](auto& numbers) {
    for (std::uint32_t& point : numbers) {
      const auto place = place_of(point);
      is_sound_ = is_sound_ && place;
      point = place.value_or(0);
    }
  };
  std::for_each(last_.begin(), last_.end(), replace);
  std::for_each(open_.begin(), open_.end(), replace);
  const std::size_t count = kept_.size() + (points_ - first_);
  std::vector<std::uint32_t> point_at(kept_);
  for (std::uint32_t point = first_; point < points_; ++point) point_at.push_back(point);
  const auto is_open = [&](std::uint32_t place) {
    return std::binary_search(kept.begin(), kept.end(), point_at[place]);
  };
  std::vector<MeshSides::Side> left;
  is_sound_ = is_sound_ && MeshSides(count, last_, open_).are_paired_but(is_open, &left);
  for (auto& side : left)
    for (std::uint32_t& place : side) place = point_at[place];
  open_ = std::move(left);
  kept_ = std::move(kept);
  first_ = points_;
  last_.clear();
}

/// Some of the hashes at a time, those with the same first bits.
bool MeshSieve::are_apart() const {
  const std::uint64_t parts = points_ / points_at_once + 1;
  bool are_apart = true;
  HashTable table;
  for (std::uint64_t part = 0; are_apart && part < parts; ++part) {
    table.clear();
    hashes_.read([&](const std::string& bytes) {
      for (std::size_t k = 0; are_apart && k < bytes.size(); k += sizeof(std::uint64_t)) {
        std::uint64_t hash = 0;
        std::memcpy(&hash, bytes.data() + k, sizeof hash);
        if ((hash >> 32) * parts >> 32 == part) are_apart = table.add(hash);
      }
    });
  }
  return are_apart;
}

bool MeshSieve::is_proved() {
  look_at_sides({});
  return is_sound_ && are_apart();
}

}  // namespace phrame
