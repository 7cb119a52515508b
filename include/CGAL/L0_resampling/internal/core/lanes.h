// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_LANES_H
#define CGAL_L0_RESAMPLING_INTERNAL_LANES_H

#include <Eigen/Core>

#include <cstddef>
#include <new>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace L0_resampling {
namespace internal {

// GCC warns where a packet type is a template argument: it loses its alignment as one, which does
// not matter here.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wignored-attributes"

/*!
As many numbers as one vector register of the target holds, computed at once.

A thin coat over Eigen's packets, which know the instructions of every processor and have a
vectorized `exp`. Eigen's arrays of fixed size would do the same, but compilers keep those in memory
between operations, which triples the time.

\tparam is_quick whether `decay()` is quick, or rounds as `exp()` does
*/
template <typename T, bool is_quick = true>
struct Lanes
{
  using Scalar = T;
  using Packet = typename Eigen::internal::packet_traits<T>::type;
  static constexpr int size = Eigen::internal::unpacket_traits<Packet>::size;

  Packet packet;

  Lanes() : packet(Eigen::internal::pset1<Packet>(T(0))) {}
  explicit Lanes(T value) : packet(Eigen::internal::pset1<Packet>(value)) {}
  /// Where a register holds one number, a packet is a value.
  template <typename P,
            std::enable_if_t<std::is_same<P, Packet>::value && !std::is_same<P, T>::value, int> = 0>
  explicit Lanes(const P& p) : packet(p)
  {}

  Lanes(max)(T low) const { return Lanes(Eigen::internal::pmax(packet, Lanes(low).packet)); }
  Lanes(min)(T high) const { return Lanes(Eigen::internal::pmin(packet, Lanes(high).packet)); }

  /// As `internal::with_sign_of()`, for the numbers of this object.
  Lanes with_sign_of(const Lanes& signs) const
  {
    using namespace Eigen::internal;
    const auto sign_bits = pand(signs.packet, Lanes(T(-0.)).packet);
    return Lanes(pandnot(por(sign_bits, packet), pcmp_eq(signs.packet, Lanes().packet)));
  }

  T sum() const { return Eigen::internal::predux(packet); }

  Lanes& operator+=(const Lanes& b) { return *this = *this + b; }

  friend Lanes operator+(const Lanes& a, const Lanes& b)
  {
    return Lanes(Eigen::internal::padd(a.packet, b.packet));
  }
  friend Lanes operator-(const Lanes& a, const Lanes& b)
  {
    return Lanes(Eigen::internal::psub(a.packet, b.packet));
  }
  friend Lanes operator*(const Lanes& a, const Lanes& b)
  {
    return Lanes(Eigen::internal::pmul(a.packet, b.packet));
  }
  friend Lanes operator/(const Lanes& a, const Lanes& b)
  {
    return Lanes(Eigen::internal::pdiv(a.packet, b.packet));
  }
  friend Lanes operator-(const Lanes& a, T b) { return a - Lanes(b); }
  friend Lanes operator-(T a, const Lanes& b) { return Lanes(a) - b; }
  friend Lanes operator*(const Lanes& a, T b) { return a * Lanes(b); }
  friend Lanes operator*(T a, const Lanes& b) { return Lanes(a) * b; }
  friend Lanes operator-(const Lanes& a) { return Lanes(Eigen::internal::pnegate(a.packet)); }
  friend Lanes abs(const Lanes& a) { return Lanes(Eigen::internal::pabs(a.packet)); }
  friend Lanes sqrt(const Lanes& a) { return Lanes(Eigen::internal::psqrt(a.packet)); }
  friend Lanes inverse_sqrt(const Lanes& a)
  {
    using namespace Eigen::internal;
    return Lanes(pdiv(Lanes(T(1)).packet, psqrt(a.packet)));
  }
  friend Lanes exp(const Lanes& a) { return Lanes(Eigen::internal::pexp(a.packet)); }

  /// \f$ e^{-x} \f$ for x >= 0, held at e^-40 as for a single number. Half the work of `exp`, which
  /// has to serve every argument: 2^y by the polynomial of least relative error (7e-8) around the
  /// integer nearest to y, which then goes into the exponent.
  friend Lanes decay(const Lanes& x)
  {
    using namespace Eigen::internal;
    if constexpr (is_quick && std::is_same<T, float>::value && size > 1)
    {
      using Integers = typename unpacket_traits<Packet>::integer_packet;
      // so large that the sum has no digits behind the point, and the integer nearest to y in its
      // lowest bits
      const Packet magic = pset1<Packet>(12582912.f);
      const Packet y = pmul((x.min)(40).packet, pset1<Packet>(-1.44269504f)), sum = padd(y, magic);
      const Packet rest = psub(y, psub(sum, magic));
      Packet power = pset1<Packet>(1.3202860e-3f);
      for (const float coefficient :
           {9.6749528e-3f, 5.5510478e-2f, 2.4022166e-1f, 6.9314660e-1f, 1.f})
        power = pmadd(power, rest, pset1<Packet>(coefficient));
      const Integers exponent = plogical_shift_left<23>(preinterpret<Integers>(sum));
      return Lanes(preinterpret<Packet>(padd(preinterpret<Integers>(power), exponent)));
    }
    else
      return exp(-(x.min)(40));
  }

  // from and to addresses of any alignment
  static Lanes load(const T* p) { return Lanes(Eigen::internal::ploadu<Packet>(p)); }
  void store(T* p) const { Eigen::internal::pstoreu(p, packet); }
};

#pragma GCC diagnostic pop

/// Of memory that begins with a line of the cache, which is what the widest registers hold.
template <typename T>
struct Allocator_of_lanes
{
  using value_type = T;
  static constexpr std::align_val_t alignment{64};

  Allocator_of_lanes() = default;
  template <typename U>
  Allocator_of_lanes(const Allocator_of_lanes<U>&)
  {}

  T* allocate(std::size_t n) { return static_cast<T*>(::operator new(n * sizeof(T), alignment)); }
  void deallocate(T* p, std::size_t) { ::operator delete(p, alignment); }

  friend bool operator==(const Allocator_of_lanes&, const Allocator_of_lanes&) { return true; }
  friend bool operator!=(const Allocator_of_lanes&, const Allocator_of_lanes&) { return false; }
};

/// Numbers that are loaded as lanes: from two lines of the cache, that takes twice as long.
template <typename T>
using Aligned_vector = std::vector<T, Allocator_of_lanes<T>>;

/// The size of arrays of which lanes compute the first `size` numbers: of whole lanes, however many
/// numbers these have.
inline std::size_t padded_to_lanes(std::size_t size)
{
  constexpr std::size_t maximum_number_of_lanes = 16;
  return (size + maximum_number_of_lanes - 1) / maximum_number_of_lanes * maximum_number_of_lanes;
}

/// The values where `a < b`, 0 elsewhere.
template <typename T>
Lanes<T> where_less(const Lanes<T>& a, T b, const Lanes<T>& values)
{
  return Lanes<T>(
    Eigen::internal::pand(Eigen::internal::pcmp_lt(a.packet, Lanes<T>(b).packet), values.packet));
}

/// Whether `a < b` in any lane.
template <typename T>
bool any_less(const Lanes<T>& a, T b)
{
  return Eigen::internal::predux_any(Eigen::internal::pcmp_lt(a.packet, Lanes<T>(b).packet));
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_LANES_H
