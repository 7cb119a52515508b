// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "hostile.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace attack {
namespace {

using Points = std::vector<Vector>;

constexpr double epsilon = Numbers::epsilon();
const Vector utm(456075.1, 5935300.5, 120.25);

/// `f(0)`, `f(1)`, ... `f(n - 1)`
Points made(std::size_t n, const std::function<Vector(double)>& f)
{
  Points points;
  for (std::size_t i = 0; i < n; ++i)
    points.push_back(f(double(i)));
  return points;
}

Points changed(Points points, const std::function<Vector(const Vector&)>& f)
{
  std::transform(points.begin(), points.end(), points.begin(), f);
  return points;
}

Points scaled(const Points& points, double factor)
{
  return changed(points, [=](const Vector& p) { return Vector(factor * p); });
}
Points moved(const Points& points, const Vector& by)
{
  return changed(points, [=](const Vector& p) { return Vector(p + by); });
}

Points joined(Points a, const Points& b)
{
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

Points repeated(const Points& points, std::size_t times)
{
  Points result;
  for (std::size_t i = 0; i < times; ++i)
    result = joined(result, points);
  return result;
}

double rounded(double x, double unit) { return unit * std::nearbyint(x / unit); }

} // namespace

std::vector<Named_points> hostile_point_sets()
{
  Generator generator(1);
  const auto random = [&](double low, double high) {
    return test::random_number(low, high, generator);
  };
  const auto cloud = [&](std::size_t n, const auto& f) {
    return made(n, [&](double) { return f(); });
  };
  const Points sphere = test::sphere_points(200, 1, generator).points;
  const Points cube = test::cube_points(250, 1, generator).points;
  const Points plane = test::plane_points(200, 1, generator).points;
  const Points ball = cloud(200, [&] {
    return Vector(std::cbrt(random(0, 1)) * test::random_unit_vector(generator));
  });
  const Points line = cloud(150, [&] { return Vector(random(-1, 1) * Vector(1, 2, 3)); });
  const Points origin{Vector(0, 0, 0)}, somewhere{Vector(1, 2, 3)};
  const auto with_nan = [&](std::size_t place, const Vector& bad) {
    Points p = sphere;
    p[place] = bad;
    return p;
  };

  return {
    // Few and equal
    {"none", {}},
    {"the origin", origin},
    {"one", somewhere},
    {"one at the largest number", {Vector(largest, -largest, largest)}},
    {"one at the least number", {Vector(Numbers::denorm_min(), 0, -Numbers::denorm_min())}},
    {"two", {Vector(1, 2, 3), Vector(1, 2, 4)}},
    {"two equal", repeated(somewhere, 2)},
    {"two neighboring numbers", {Vector(1, 1, 1), Vector(1, 1, 1 + epsilon)}},
    {"two at opposite ends of the numbers",
     {Vector(largest, largest, largest), Vector(-largest, -largest, -largest)}},
    {"three", {Vector(0, 0, 0), Vector(1, 0, 0), Vector(0, 1, 0)}},
    {"five, fewer than a plane needs", test::sphere_points(5, 1, generator).points},
    {"300 equal", repeated(somewhere, 300)},
    {"300 at the origin", repeated(origin, 300)},
    {"negative zeros and zeros",
     joined(repeated(origin, 20), repeated({Vector(-0., -0., -0.)}, 20))},
    {"two piles", joined(repeated(origin, 100), repeated({Vector(1, 1, 1)}, 100))},
    {"a pile and a sphere", joined(repeated({Vector(0, 0, 1)}, 100), sphere)},
    {"each three times", repeated(Points(sphere.begin(), sphere.begin() + 100), 3)},
    {"nearly equal",
     cloud(200, [&] { return Vector(1 + epsilon * rounded(random(0, 8), 1), 1, 1); })},
    {"a lattice of a few units in the last place",
     moved(test::lattice_points(6, epsilon), Vector(1, 1, 1))},
    // Flat, thin, in rows
    {"an oblique line", line},
    {"a line along an axis", made(200, [](double i) { return Vector(i, 0, 0); })},
    {"a line with gaps that double",
     made(60, [](double i) { return Vector(std::ldexp(1., int(i)), 0, 0); })},
    {"a parabola", made(200, [](double i) { return Vector(i, i * i, 0); })},
    {"a helix",
     made(250, [](double i) { return Vector(std::cos(i / 9), std::sin(i / 9), i / 90); })},
    {"a plane", plane},
    {"a plane off the origin", moved(plane, Vector(0, 0, 1e-3))},
    {"an oblique plane at UTM",
     changed(plane,
             [](const Vector& p) { return Vector(p + utm + Vector(0, 0, p[0] / 3 + p[1] / 7)); })},
    {"two planes nearly one", joined(plane, moved(plane, Vector(0, 0, 1e-9)))},
    {"two crossing planes",
     joined(plane, changed(plane, [](const Vector& p) { return Vector(p[0], 0, p[1]); }))},
    {"two crossing lines",
     joined(line, changed(line, [](const Vector& p) { return Vector(-p[0], p[1], p[2]); }))},
    {"a needle",
     cloud(200, [&] { return test::random_vector(Vector(1, 1e-7, 1e-14), generator); })},
    {"a sheet as thin as rounding",
     cloud(200,
           [&] {
             return test::random_vector(Vector(0, 0, 0), Vector(1, 1, 4 * epsilon), generator);
           })},
    // Ties
    {"a lattice", test::lattice_points(6, 0.1)},
    {"a flat lattice",
     made(256, [](double i) { return Vector(std::fmod(i, 16), std::floor(i / 16), 0); })},
    {"a lattice with doubled nodes", repeated(test::lattice_points(5, 1), 2)},
    {"a lattice of tenths at UTM", moved(test::lattice_points(6, 0.1), utm)},
    {"corners of a cube, each many times", repeated(test::lattice_points(2, 1), 25)},
    {"two concentric spheres", joined(sphere, scaled(sphere, 1.000001))},
    {"a regular circle", made(240,
                              [](double i) {
                                return Vector(std::cos(i * double(EIGEN_PI) / 120),
                                              std::sin(i * double(EIGEN_PI) / 120), 0);
                              })},
    // Solid, uneven, torn
    {"a sphere", sphere},
    {"a cube", cube},
    {"a solid ball", ball},
    {"a noise without surface", cloud(250, [&] { return test::random_vector(1, generator); })},
    {"density over ten orders",
     cloud(250,
           [&] { return Vector(std::exp(random(-20, 2)) * test::random_unit_vector(generator)); })},
    {"geometric shells", made(120,
                              [&](double i) {
                                return Vector(std::ldexp(1., int(i) - 60)
                                              * test::random_unit_vector(generator));
                              })},
    {"all binades", made(300,
                         [](double i) {
                           return Vector(std::ldexp(1., int(i) * 6 - 900), std::ldexp(1., -int(i)),
                                         0);
                         })},
    {"two far clusters",
     joined(sphere, moved(Points(sphere.begin(), sphere.begin() + 80), Vector(1e4, 0, 0)))},
    {"two clusters further apart than digits",
     joined(sphere, moved(Points(sphere.begin(), sphere.begin() + 80), Vector(1e17, 0, 0)))},
    {"twenty islands", made(300,
                            [&](double i) {
                              return Vector(100 * std::fmod(i, 20) * Vector(1, 0.3, 0)
                                            + 1e-3 * test::random_unit_vector(generator));
                            })},
    {"a crowd beside a sphere", joined(sphere, scaled(moved(ball, Vector(1e4, 0, 0)), 1e-4))},
    {"an exponential tail",
     cloud(250,
           [&] {
             return Vector{std::exp(random(0, 300)), std::exp(random(0, 300)), 0};
           })},
    // Far and extreme
    {"UTM", moved(sphere, utm)},
    {"ten billions away", moved(cube, Vector(1e10, -1e10, 1e10))},
    {"further away than digits", moved(cube, Vector(1e15, 1e16, -1e17))},
    {"1e-300", scaled(sphere, 1e-300)},
    {"1e300", scaled(cube, 1e300)},
    {"the largest numbers", scaled(sphere, largest)},
    {"corners of all numbers", changed(test::lattice_points(4, 1),
                                       [](const Vector& p) {
                                         return Vector((p[0] - 1.5) / 1.5 * largest,
                                                       (p[1] - 1.5) / 1.5 * largest,
                                                       (p[2] - 1.5) / 1.5 * largest);
                                       })},
    {"denormal numbers", scaled(sphere, 1e-315)},
    {"the least numbers", scaled(sphere, 1e-322)},
    {"three units",
     changed(ball, [](const Vector& p) { return Vector(1e-200 * p[0], p[1], 1e200 * p[2]); })},
    {"one axis of denormal numbers",
     changed(cube, [](const Vector& p) { return Vector(p[0], p[1], 1e-312 * p[2]); })},
    {"an outlier at 1e9", joined(sphere, {Vector(1e9, 1e9, 1e9)})},
    {"an outlier at 1e300", joined(sphere, {Vector(1e300, 0, -1e300)})},
    {"an outlier among denormal numbers",
     joined(scaled(sphere, 1e-315), {Vector(largest, -largest, 0)})},
    {"outliers as many as points",
     joined(scaled(ball, 1e-3), Points(ball.begin(), ball.begin() + 100))},
    {"every outlier at another order",
     joined(sphere, made(40, [](double i) { return Vector(std::pow(10., i), 0, 0); }))},
    // Not numbers
    {"a NaN first", with_nan(0, Vector(nan, 0, 0))},
    {"a NaN last", with_nan(199, Vector(0, 0, nan))},
    {"infinities", with_nan(7, Vector(0, -infinity, infinity))},
    {"nothing but NaN", repeated({Vector(nan, nan, nan)}, 50)},
    {"one number among NaN", joined(repeated({Vector(nan, nan, nan)}, 50), somewhere)},
    {"every second a NaN", joined(sphere, repeated({Vector(1, nan, 1)}, 100))},
  };
}

std::vector<Vector> random_normals(std::size_t n, Generator& generator)
{
  const auto random = [&](double low, double high) {
    return test::random_number(low, high, generator);
  };
  const double share_of_useless = random(0, 1) < 0.5 ? 0 : random(0, 1);
  const bool all_alike = random(0, 1) < 0.1;
  const Vector common = test::random_unit_vector(generator);
  const std::vector<Vector> useless{Vector(0, 0, 0), Vector(nan, 0, 0), Vector(infinity, 1, 0),
                                    Vector(-0., 0, -0.)};
  Points normals;
  for (std::size_t i = 0; i < n; ++i)
  {
    const double length = random(0, 1) < 0.8 ? 1 : std::pow(10., random(-320, 308));
    if (random(0, 1) < share_of_useless)
      normals.push_back(useless[std::size_t(random(0, 4))]);
    else
      normals.push_back(length * (all_alike ? common : test::random_unit_vector(generator)));
  }
  return normals;
}

std::vector<Vector> random_point_set(Generator& generator)
{
  static const std::vector<Named_points> named = hostile_point_sets();
  const auto random = [&](double low, double high) {
    return test::random_number(low, high, generator);
  };
  const auto one_in = [&](double n) { return random(0, n) < 1; };
  const auto random_size = [&] { return std::size_t(std::pow(random(0, 1), 2) * 300); };
  const auto random_vector = [&] { return test::random_vector(1, generator); };

  Points points;
  const std::size_t n = random_size();
  switch (int(random(0, 6)))
  {
  case 0: points = named[std::size_t(random(0, double(named.size())))].points; break;
  case 1: points = test::sphere_points(n, 1, generator).points; break;
  case 2: points = test::cube_points(n, 1, generator).points; break;
  case 3: points = test::plane_points(n, 1, generator).points; break;
  case 4: points = made(n, [&](double) { return random_vector(); }); break;
  default:
    points = made(n, [&](double) {
      return Vector(std::exp(random(-9, 0)) * test::random_unit_vector(generator));
    });
  }

  const int number_of_misfortunes = int(random(0, 5));
  for (int misfortune = 0; misfortune < number_of_misfortunes && !points.empty(); ++misfortune)
  {
    const std::size_t some = std::size_t(random(0, double(points.size())));
    switch (int(random(0, 14)))
    {
    case 0: points = scaled(points, std::pow(10., random(-12, 12))); break;
    case 1: points = scaled(points, std::pow(10., random(-320, 308))); break;
    case 2: points = moved(points, std::pow(10., random(-3, 18)) * random_vector()); break;
    case 3: test::add_gaussian_noise(points, std::pow(10., random(-16, 0)), generator); break;
    case 4:
      points = joined(points, Points(points.begin(), points.begin() + std::ptrdiff_t(some)));
      break;
    case 5: points = joined(points, repeated({points[some]}, random_size())); break;
    case 6: points.push_back(std::pow(10., random(-5, 300)) * random_vector()); break;
    case 7:
      points = joined(points, moved(points, std::pow(10., random(-17, 5)) * random_vector()));
      break;
    case 8: {
      const double unit = std::pow(10., random(-3, 0))
                          * (points[some].cwiseAbs().maxCoeff() + Numbers::denorm_min());
      points = changed(points, [=](const Vector& p) {
        return Vector(rounded(p[0], unit), rounded(p[1], unit), rounded(p[2], unit));
      });
      break;
    }
    case 9: {
      const Vector stretch(std::pow(10., random(-20, 0)),
                           one_in(2) ? 1 : std::pow(10., random(-20, 0)), one_in(8) ? 0 : 1);
      points = changed(points, [=](const Vector& p) { return Vector(p.cwiseProduct(stretch)); });
      break;
    }
    case 10:
      std::sort(points.begin(), points.end(),
                [](const Vector& a, const Vector& b) { return a[0] < b[0]; });
      break;
    case 11: points.resize((std::max)(some, std::size_t(1))); break;
    case 12:
      points = joined(points, named[std::size_t(random(0, double(named.size())))].points);
      break;
    default:
      if (one_in(3))
        points[some][Eigen::Index(random(0, 3))] = one_in(2) ? nan : infinity;
    }
  }
  if (points.size() > 300)
  {
    std::shuffle(points.begin(), points.end(), generator);
    points.resize(300);
  }
  return points;
}

} // namespace attack
