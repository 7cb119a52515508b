// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The filter filters.l0resample of PDAL, a plugin: from the points of each view to a new view of
// oriented points.

#include <CGAL/Simple_cartesian.h>
#include <CGAL/l0_resample_point_set.h>

#include <pdal/Filter.hpp>
#include <pdal/PluginHelper.hpp>
#include <pdal/PointView.hpp>
#include <pdal/util/ProgramArgs.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <iterator>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Dimension = pdal::Dimension::Id;
using CGAL::L0_resampling::Method;

const pdal::PluginInfo plugin_info{
  "filters.l0resample",
  "L0 resampling: as many clean, evenly spaced, oriented points as asked for, which keep sharp "
  "features",
  ""};

/// Keeps, for each point of the result, the index of the input point nearest to it. The number of
/// points is known once they are written.
struct Source_map
{
  using key_type = std::size_t;
  using value_type = pdal::PointId;
  using reference = pdal::PointId;
  using category = boost::writable_property_map_tag;

  std::vector<pdal::PointId>* sources;

  friend void put(const Source_map& map, std::size_t key, pdal::PointId source)
  {
    if (key >= map.sources->size())
      map.sources->resize(key + 1);
    (*map.sources)[key] = source;
  }
};

class L0_resample_filter : public pdal::Filter
{
  using Pair = std::pair<Kernel::Point_3, Kernel::Vector_3>;

  std::string m_method;
  std::uint64_t m_count = 0, m_seed = 0;
  double m_percentage = 0, m_radius = 0, m_normal_weight = 0, m_sharpness_angle = 0;
  pdal::Arg *m_count_arg = nullptr, *m_radius_arg = nullptr;

public:
  std::string getName() const override { return plugin_info.name; }

private:
  void addArgs(pdal::ProgramArgs& args) override
  {
    m_count_arg = &args.add("count", "Number of points of the result", m_count);
    args.add("percentage", "Number of points of the result, in percent of the input", m_percentage,
             50.);
    args.add("method", "default, lor or alor", m_method, std::string("default"));
    m_radius_arg = &args.add("radius",
                             "Neighborhood radius, in the unit of the points; chosen by "
                             "spacing and noise if not given",
                             m_radius);
    args.add("normal_weight", "Price of a jump across a tangent plane: larger for sharper edges",
             m_normal_weight, 0.9);
    args.add("sharpness_angle", "Normals that differ by much more are not averaged, in degrees",
             m_sharpness_angle, 15.);
    args.add("seed", "Chooses where the points of the result start", m_seed, std::uint64_t(0));
  }

  void addDimensions(pdal::PointLayoutPtr layout) override
  {
    layout->registerDims({Dimension::NormalX, Dimension::NormalY, Dimension::NormalZ});
  }

  Method chosen_method() const
  {
    if (m_method == "lor")
      return Method::LOR;
    if (m_method == "alor")
      return Method::ALOR;
    if (m_method != "default")
      throwError("method is '" + m_method + "', expected default, lor or alor");
    return Method::DEFAULT;
  }

  /// The points of one view, resampled. Dimensions other than positions and normals are those of
  /// the nearest point of the input.
  pdal::PointViewSet run(pdal::PointViewPtr view) override
  {
    std::vector<Kernel::Point_3> points;
    points.reserve(view->size());
    for (pdal::PointId i = 0; i < view->size(); ++i)
      points.emplace_back(view->getFieldAs<double>(Dimension::X, i),
                          view->getFieldAs<double>(Dimension::Y, i),
                          view->getFieldAs<double>(Dimension::Z, i));

    std::vector<Pair> result;
    std::vector<pdal::PointId> sources;
    CGAL::L0_resampling::Report report;
    const Method method = chosen_method();
    const auto count = m_count_arg->set() ? std::make_optional(m_count) : std::nullopt;
    const auto radius = m_radius_arg->set() ? std::make_optional(m_radius) : std::nullopt;
    try
    {
      CGAL::l0_resample_point_set<CGAL::Parallel_if_available_tag>(
        points, std::back_inserter(result),
        CGAL::parameters::resampling_method(method)
          .number_of_output_points(count)
          .select_percentage(m_percentage)
          .neighbor_radius(radius)
          .normal_weight(m_normal_weight)
          .sharpness_angle(m_sharpness_angle)
          .random_seed(m_seed)
          .source_index_map(Source_map{&sources})
          .resampling_report(&report));
    }
    catch (const std::exception& error)
    {
      throwError(error.what());
    }
    for (const CGAL::L0_resampling::Warning warning : CGAL::L0_resampling::warnings(report))
      log()->get(pdal::LogLevel::Warning) << message_of(warning, report) << std::endl;

    pdal::PointViewPtr output = view->makeNew();
    const pdal::DimTypeList dimensions = view->dimTypes();
    std::array<char, 8> value; // of any type
    for (std::size_t i = 0; i < result.size(); ++i)
    {
      // New points share no memory with those of the input, of which several may have the same.
      for (const pdal::DimType& dimension : dimensions)
      {
        view->getField(value.data(), dimension.m_id, dimension.m_type, sources[i]);
        output->setField(dimension.m_id, dimension.m_type, i, value.data());
      }
      const auto& [point, normal] = result[i];
      output->setField(Dimension::X, i, point.x());
      output->setField(Dimension::Y, i, point.y());
      output->setField(Dimension::Z, i, point.z());
      output->setField(Dimension::NormalX, i, normal.x());
      output->setField(Dimension::NormalY, i, normal.y());
      output->setField(Dimension::NormalZ, i, normal.z());
    }
    pdal::PointViewSet views;
    views.insert(output);
    return views;
  }
};

} // namespace

CREATE_SHARED_STAGE(L0_resample_filter, plugin_info)
