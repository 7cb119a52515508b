// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The filter on a sphere whose halves have other classes: test_pdal_filter PLUGIN, the file of the
// plugin.

#include "../../test/L0_resampling/test_support.h"

#include <pdal/Filter.hpp>
#include <pdal/Options.hpp>
#include <pdal/PluginManager.hpp>
#include <pdal/PointTable.hpp>
#include <pdal/io/BufferReader.hpp>

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <memory>
#include <string>

namespace {

using Dimension = pdal::Dimension::Id;

constexpr int size = 3000, class_above = 6, class_below = 2;
constexpr double east = 500000; // of the center, as coordinates of maps have it

/// Adds points of the sphere, each with its number as intensity.
void fill(pdal::PointView& view)
{
  test::Generator generator(1);
  for (int i = 0; i < size; ++i)
  {
    test::Vector p;
    do
      for (int axis = 0; axis < 3; ++axis)
        p[axis] = test::random_number(-1, 1, generator);
    while (p.norm() > 1 || p.norm() < 0.1);
    p.normalize();
    const auto id = pdal::PointId(i);
    view.setField(Dimension::X, id, east + p[0]);
    view.setField(Dimension::Y, id, p[1]);
    view.setField(Dimension::Z, id, p[2]);
    view.setField(Dimension::Classification, id, p[2] > 0 ? class_above : class_below);
    view.setField(Dimension::Intensity, id, i);
  }
}

test::Vector at(const pdal::PointView& view, pdal::PointId i, Dimension x, Dimension y, Dimension z)
{
  return {view.getFieldAs<double>(x, i), view.getFieldAs<double>(y, i),
          view.getFieldAs<double>(z, i)};
}

/// Runs the filter, and checks all but the number of points of the result, which it returns.
std::size_t run(const pdal::Options& options)
{
  pdal::PointTable table;
  table.layout()->registerDims(
    {Dimension::X, Dimension::Y, Dimension::Z, Dimension::Classification, Dimension::Intensity});
  const std::unique_ptr<pdal::Stage> filter(
    pdal::PluginManager<pdal::Stage>::createObject("filters.l0resample"));
  if (!CHECK(filter))
    return 0;
  const pdal::PointViewPtr view(new pdal::PointView(table));
  pdal::BufferReader reader;
  reader.addView(view);
  filter->setInput(reader);
  filter->setOptions(options);
  filter->prepare(table);
  fill(*view);
  const pdal::PointViewSet views = filter->execute(table);
  CHECK(views.size() == 1);

  const pdal::PointView& result = **views.begin();
  for (pdal::PointId i = 0; i < result.size(); ++i)
  {
    test::Vector p = at(result, i, Dimension::X, Dimension::Y, Dimension::Z);
    p[0] -= east;
    CHECK(std::abs(p.norm() - 1) < 0.05);
    CHECK(p.dot(at(result, i, Dimension::NormalX, Dimension::NormalY, Dimension::NormalZ)) > 0.9);
    const int class_of_point = result.getFieldAs<int>(Dimension::Classification, i);
    CHECK(std::abs(p[2]) < 0.1 || class_of_point == (p[2] > 0 ? class_above : class_below));
  }
  // the input is as it was, where points of the result share the nearest one too
  pdal::PointTable untouched;
  untouched.layout()->registerDims(
    {Dimension::X, Dimension::Y, Dimension::Z, Dimension::Classification, Dimension::Intensity});
  untouched.finalize();
  pdal::PointView expected(untouched);
  fill(expected);
  CHECK(view->size() == expected.size());
  for (pdal::PointId i = 0; i < expected.size(); ++i)
    CHECK(at(*view, i, Dimension::X, Dimension::Y, Dimension::Z)
            == at(expected, i, Dimension::X, Dimension::Y, Dimension::Z)
          && view->getFieldAs<int>(Dimension::Intensity, i) == int(i));
  return result.size();
}

template <typename Value>
pdal::Options option(const std::string& name, const Value& value)
{
  pdal::Options options;
  options.add(name, value);
  return options;
}

} // namespace

int main(int argc, char* argv[])
{
  if (argc != 2 || !pdal::PluginManager<pdal::Stage>::loadPlugin(argv[1]))
  {
    std::cerr << "cannot load the plugin" << std::endl;
    return EXIT_FAILURE;
  }
  CHECK(run(pdal::Options()) == size / 2);
  CHECK(run(option("percentage", 20)) == size / 5);
  CHECK(run(option("count", 4000)) == 4000);
  pdal::Options lor = option("method", "lor");
  lor.add("count", 400);
  lor.add("radius", 0.3);
  CHECK(run(lor) == 400);
  CHECK_THROWS(run(option("method", "best")), pdal::pdal_error);
  CHECK_THROWS(run(option("radius", -1)), pdal::pdal_error);
  return test::result();
}
