// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Properties that samples of tiles get from files: those of the same samples in memory, to the bit.

#include "test_support.h"

#include "basis/Failure.h"
#include "tasks/carry_properties.h"
#include "tiles/Property_interpolator.h"
#include "tiles/Input_properties.h"
#include "tiles/Shard.h"

#include <CGAL/L0_resampling/internal/search/nearest_input_points.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <map>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include <unistd.h>

namespace {

using namespace l0_tool;
namespace internal = CGAL::L0_resampling::internal;
using CGAL::L0_resampling::Index;
using Place = std::array<double, 3>;

constexpr std::uint64_t key = 7;

/// Points of several files, one after the other, with their rows.
struct Cloud
{
  std::vector<Place> points;
  std::vector<std::size_t> ends; ///< of the files
  Property_table properties;
};

Property_table no_rows()
{
  Property_table table;
  table.add_property("red", Number_type::UINT8);
  table.add_property("kind", Number_type::INT32);
  table.add_property("height", Number_type::FLOAT32);
  return table;
}

/// A place that is as far from one point as from another, in another block of side 2.
Place middle_of_pair(int i) { return {40. + 8 * i, 40, 0}; }

constexpr int number_of_pairs = 30;

/// A patch, with places that many points of several files share, pairs of points, and strays far
/// from it and from each other.
Cloud random_cloud()
{
  std::mt19937 random(3);
  std::uniform_real_distribution<double> inside(0, 20);
  Cloud cloud;
  for (int i = 0; i < 6000; ++i)
    cloud.points.push_back({inside(random), inside(random), inside(random) / 40});
  for (int i = 0; i < 25; ++i)
    for (int k = 0; k < i; ++k)
      cloud.points.push_back({0.8 * i, 0.7 * i, 0.25});
  for (int i = 0; i < 12; ++i)
    cloud.points.push_back({-300. * i, 40. * i * i, 70});
  for (int i = 0; i < number_of_pairs; ++i)
    for (const double shift : {-1, 1})
      cloud.points.push_back({middle_of_pair(i)[0] + shift, 40, 0});
  std::shuffle(cloud.points.begin(), cloud.points.end(), random);
  cloud.ends = {2500, 2501, cloud.points.size()};
  cloud.properties = no_rows();
  std::vector<char> row(cloud.properties.row_size());
  const auto& properties = cloud.properties.properties();
  for (std::size_t i = 0; i < cloud.points.size(); ++i)
  {
    encode(double(random() % 256), properties[0].type, row.data() + properties[0].offset);
    encode(double(i), properties[1].type, row.data() + properties[1].offset);
    encode(inside(random), properties[2].type, row.data() + properties[2].offset);
    cloud.properties.append(row.data());
  }
  return cloud;
}

/// Among the points, on some of them, between those of pairs, and far from all.
std::vector<Tile_sample> random_samples(const Cloud& cloud)
{
  std::mt19937 random(4);
  std::uniform_real_distribution<double> inside(-1, 21);
  std::vector<Tile_sample> samples;
  for (std::size_t i = 0; i < 1500; ++i)
  {
    const Place place = i % 3 == 0    ? cloud.points[random() % cloud.points.size()]
                        : i % 50 == 1 ? Place{50 * inside(random), -200, 9}
                                      : Place{inside(random), inside(random), inside(random) / 40};
    samples.push_back({place, {0, 0, 1}, 0});
  }
  for (int i = 0; i < number_of_pairs; ++i)
    samples.push_back({middle_of_pair(i), {0, 0, 1}, 0});
  return samples;
}

/// As the tool carries properties where all points are in memory.
std::vector<char> rows_in_memory(const Cloud& cloud, const std::vector<Tile_sample>& samples)
{
  internal::Buffer<internal::Vector> points;
  internal::Buffer<Index> indices;
  for (const Place& point : cloud.points)
  {
    indices.push_back(Index(points.size()));
    points.push_back(internal::Vector(point.data()));
  }
  internal::Buffer<Place> positions;
  for (const Tile_sample& sample : samples)
    positions.push_back(sample.position);
  CGAL::L0_resampling::Report report;
  internal::Memory_counter memory;
  internal::Progress progress(nullptr, report, memory);
  CGAL::L0_resampling::Near_points near;
  near.count = CGAL::L0_resampling::number_of_averaged_points;
  internal::nearest_input_points<CGAL::Sequential_tag>(
    internal::Point_tree_3(CGAL::Sequential_tag(), std::move(points), std::move(indices)),
    positions, progress, near);
  const Property_table table = carried_properties(cloud.properties, near, {}, {}, samples.size());
  return {table.row(0), table.row(0) + samples.size() * table.row_size()};
}

/// The files of a run.
class Files
{
  std::string m_folder;

public:
  Files()
  {
    char name[] = "/tmp/test_tool_carry_XXXXXX";
    m_folder = mkdtemp(name);
  }

  std::vector<std::string> paths(const std::string& kind, std::size_t number) const
  {
    std::vector<std::string> result;
    for (std::size_t k = 0; k < number; ++k)
      result.push_back(m_folder + "/" + kind + std::to_string(k));
    return result;
  }

  ~Files()
  {
    for (const char* kind : {"shard", "rows"})
      for (const std::string& path : paths(kind, 9))
        unlink(path.c_str());
    rmdir(m_folder.c_str());
  }
};

/// Cuts the samples into as many parts along an axis as tiles, and puts their rows together.
/// \param bytes_of_run of the shards
/// \param memory of a tile
std::vector<char> rows_by_tiles(const Cloud& cloud, const std::vector<Tile_sample>& samples,
                                std::size_t number_of_tiles, int exponent,
                                std::uint64_t bytes_of_run, std::uint64_t memory)
{
  const Files files;
  const Block_lattice lattice(exponent);
  const std::vector<std::string> paths = files.paths("shard", cloud.ends.size()),
                                 paths_of_rows = files.paths("rows", cloud.ends.size());
  const std::size_t row_size = cloud.properties.row_size();
  std::map<Block, std::uint64_t> counts;
  std::size_t i = 0;
  for (std::size_t file = 0; file < cloud.ends.size(); ++file)
  {
    Shard_writer writer(paths[file], paths_of_rows[file], key, lattice, row_size, bytes_of_run);
    for (; i < cloud.ends[file]; ++i)
    {
      const char* const row = cloud.properties.row(i);
      writer.add(cloud.points[i], std::vector<char>(row, row + row_size));
      ++counts[lattice.block_of(cloud.points[i])];
    }
    writer.commit();
  }
  const std::vector<std::pair<Block, std::uint64_t>> blocks(counts.begin(), counts.end());
  const Shards shards(paths, key, lattice);

  std::vector<std::size_t> order(samples.size());
  for (std::size_t k = 0; k < order.size(); ++k)
    order[k] = k;
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return samples[a].position[1] < samples[b].position[1];
  });
  std::vector<char> result(samples.size() * row_size);
  for (std::size_t tile = 0; tile < number_of_tiles; ++tile)
  {
    const std::size_t begin = samples.size() * tile / number_of_tiles,
                      end = samples.size() * (tile + 1) / number_of_tiles;
    std::vector<Tile_sample> of_tile;
    for (std::size_t k = begin; k < end; ++k)
      of_tile.push_back(samples[order[k]]);
    Property_interpolator interpolator(shards, paths_of_rows, key, lattice, blocks, no_rows(),
                                       memory);
    const std::vector<char> rows = interpolator.carry(of_tile, [](double) {});
    for (std::size_t k = begin; k < end; ++k)
      std::memcpy(result.data() + order[k] * row_size, rows.data() + (k - begin) * row_size,
                  row_size);
  }
  return result;
}

void test_bits_of_memory()
{
  const Cloud cloud = random_cloud();
  const std::vector<Tile_sample> samples = random_samples(cloud);
  const std::vector<char> expected = rows_in_memory(cloud, samples);
  const std::uint64_t much = 1 << 30, little = 100000;
  for (const std::size_t tiles : {1, 4, 16})
    CHECK(rows_by_tiles(cloud, samples, tiles, 1, much, much) == expected);
  for (const int exponent : {-1, 1, 12}) // of the sides of blocks
    CHECK(rows_by_tiles(cloud, samples, 4, exponent, much, little) == expected);
  CHECK(rows_by_tiles(cloud, samples, 4, 1, 20000, much) == expected);
  CHECK(rows_by_tiles(cloud, {}, 1, 1, much, much).empty());
}

void test_fewer_points_than_neighbors()
{
  Cloud cloud = random_cloud();
  cloud.points.resize(5);
  cloud.ends = {2, 4, 5};
  const std::vector<Tile_sample> samples = random_samples(cloud);
  CHECK(rows_by_tiles(cloud, samples, 4, -1, 1 << 20, 1 << 20) == rows_in_memory(cloud, samples));
}

Input_properties of_file(const std::string& input, const std::string& name, Number_type type)
{
  Point_cloud cloud;
  cloud.properties.add_property(name, type);
  return properties_of_input(input, cloud, true);
}

/// As another process reads it.
Input_properties from_file(const Input_properties& properties)
{
  const Files files;
  const std::string path = files.paths("rows", 1).front();
  Task_file_writer writer(path, key);
  write_properties(properties, writer);
  writer.commit();
  Task_file file(path, key);
  return read_properties(file);
}

void test_types_of_several_files()
{
  const auto joined = [](Number_type a, Number_type b) {
    Input_properties all;
    add_input(of_file("a", "kind", a), all);
    add_input(of_file("b", "kind", b), all);
    return all.properties.at(0).type;
  };
  CHECK(joined(Number_type::UINT8, Number_type::UINT8) == Number_type::UINT8);
  CHECK(joined(Number_type::INT8, Number_type::UINT8) == Number_type::INT16);
  CHECK(joined(Number_type::UINT16, Number_type::UINT8) == Number_type::UINT16);
  CHECK(joined(Number_type::INT32, Number_type::UINT32) == Number_type::FLOAT64);
  CHECK(joined(Number_type::INT16, Number_type::FLOAT32) == Number_type::FLOAT32);
  CHECK(joined(Number_type::INT32, Number_type::FLOAT32) == Number_type::FLOAT64);

  // Colors are kept as they are, which is said once
  Input_properties all;
  for (const Number_type type : {Number_type::UINT8, Number_type::UINT16, Number_type::UINT8})
    add_input(of_file("file", "red", type), all);
  CHECK(all.properties.at(0).type == Number_type::UINT16 && all.warnings.size() == 1);
}

/// A file of LAS with one point, of which the values of that are given.
struct Las_input
{
  std::string name;
  Las_colors colors;
  double red, depth;
};

/// Red and depth of the points of all of these.
/// \param are_wide whether the colors keep their 16 bits
std::vector<std::array<double, 2>> values_of_all(const std::vector<Las_input>& inputs,
                                                 bool are_wide,
                                                 std::vector<std::string>* warnings = nullptr)
{
  Property_table given;
  given.add_property("depth", Number_type::UINT16);
  given.add_property("red", Number_type::UINT16);
  Input_properties all;
  for (const Las_input& input : inputs)
  {
    Point_cloud cloud;
    cloud.properties = given;
    cloud.las_colors = input.colors;
    const bool is_scaled = input.colors == Las_colors::SCALED_BYTES
                           || input.colors == Las_colors::FINE;
    if (!are_wide)
    {
      cloud.narrowed = {{Number_type::UINT16, 0}, {Number_type::UINT16, is_scaled ? 8u : 0u}};
      cloud.properties.narrow({Number_type::UINT16, Number_type::UINT8});
    }
    add_input(from_file(properties_of_input(input.name, cloud, true)), all);
  }
  choose_inputs_of_bytes(all);
  all = from_file(all);
  if (warnings)
    *warnings = all.warnings;
  std::vector<std::array<double, 2>> values;
  for (const Las_input& input : inputs)
  {
    std::vector<char> row(given.row_size());
    encode(input.depth, Number_type::UINT16, row.data());
    encode(input.red, Number_type::UINT16, row.data() + 2);
    Property_table table = all.table();
    table.append(Row_converter(all, input.name)(given, row.data()).data());
    values.push_back({table.value(0, *table.find("red")), table.value(0, *table.find("depth"))});
  }
  return values;
}

// A file with colors of bytes gets those of others, but may be a dark tile of fine ones.
void test_colors_of_several_files()
{
  using Values = std::vector<std::array<double, 2>>;
  const Las_input bytes = {"bytes", Las_colors::BYTES, 200, 100},
                  scaled = {"scaled", Las_colors::SCALED_BYTES, 200 * 257, 100},
                  fine = {"fine", Las_colors::FINE, 200 * 257 + 1, 100},
                  black = {"black", Las_colors::NONE, 0, 100};
  const std::array<double, 2> wide = {200 * 257, 100}, narrow = {200, 100}, none = {0, 100};
  std::vector<std::string> warnings;
  for (const std::vector<Las_input>& inputs :
       {std::vector<Las_input>{bytes, scaled, black}, std::vector<Las_input>{black, scaled, bytes}})
    for (const bool are_wide : {false, true})
    {
      const std::array<double, 2> value = are_wide ? wide : narrow;
      Values expected = {value, value, none};
      if (inputs[0].name == "black")
        std::swap(expected[0], expected[2]);
      CHECK(values_of_all(inputs, are_wide, &warnings) == expected && warnings.empty());
    }
  CHECK((values_of_all({bytes, black}, false, &warnings) == Values{narrow, none}));
  CHECK(warnings.empty());
  CHECK((values_of_all({black, bytes}, true) == Values{none, narrow}));
  CHECK((values_of_all({fine, black, scaled}, false, &warnings) == Values{narrow, none, narrow}));
  CHECK(warnings.empty());

  CHECK((values_of_all({bytes, scaled, fine}, false, &warnings) == Values{none, narrow, narrow}));
  CHECK(warnings.size() == 1 && warnings[0].find("bytes: the colors are at most 255") == 0);
  CHECK((values_of_all({fine, bytes}, true, &warnings) == Values{{200 * 257 + 1, 100}, narrow}));
  CHECK(warnings.size() == 1);
}

// A property is one of labels if it is in all files.
void test_whole_numbers_of_several_files()
{
  const auto of_numbers = [](const std::string& input, bool are_whole) {
    Input_properties properties = of_file(input, "kind", Number_type::FLOAT32);
    properties.properties[0].is_measured = !are_whole;
    return properties;
  };
  for (const bool first : {false, true})
    for (const bool second : {false, true})
    {
      Input_properties all;
      add_input(of_numbers("a", first), all);
      add_input(of_numbers("b", second), all);
      CHECK(all.table().properties().at(0).is_measured == !(first && second));
    }
  Input_properties all;
  add_input(of_file("bytes", "kind", Number_type::UINT8), all);
  add_input(of_numbers("floats", true), all);
  CHECK(!all.table().properties().at(0).is_measured);
}

// What stands for no data in any file does so in all.
void test_no_data_of_several_files()
{
  Input_properties all;
  for (const double mark : {-9999., -99999., -9999.})
  {
    Input_properties properties = of_file("file", "depth", Number_type::FLOAT32);
    properties.properties[0].no_data = {mark};
    add_input(properties, all);
  }
  CHECK(all.table().properties().at(0).no_data == (std::vector<double>{-9999, -99999}));
  CHECK(from_file(all).properties[0].no_data == all.properties[0].no_data);
}

template <typename F>
std::string refusal_of(const F& f)
{
  try
  {
    f();
  }
  catch (const Failure& failure)
  {
    CHECK(failure.status() == INPUT_REFUSED);
    return failure.what();
  }
  return "";
}

void test_refusals()
{
  Input_properties all;
  add_input(of_file("a.ply", "kind", Number_type::UINT8), all);
  for (const bool is_more : {false, true})
  {
    Input_properties other = of_file("b.ply", is_more ? "kind" : "height", Number_type::UINT8);
    if (is_more)
      other.properties.push_back({"height", Number_type::UINT8, {{Number_type::UINT8, 0}}});
    const std::string message = refusal_of([&]() { add_input(other, all); });
    CHECK(message.find(is_more ? "a.ply: the points have no property 'height', as those of b.ply"
                               : "b.ply: the points have no property 'kind', as those of a.ply")
          == 0);
  }
  add_input(properties_of_input("empty.xyz", Point_cloud(), false), all); // lacks nothing
  Property_table given;
  given.add_property("kind", Number_type::INT16);
  const std::vector<char> row(2);
  CHECK(refusal_of([&]() { Row_converter(all, "a.ply")(given, row.data()); }).find("has changed")
        != std::string::npos);
}

void test_coordinate_systems()
{
  const auto of_system = [](const std::string& input, const std::string& system) {
    Input_properties properties;
    properties.input = input;
    properties.las.emplace();
    if (!system.empty())
      properties.las->coordinate_system.push_back({"LASF_Projection", 2112, "", system});
    return properties;
  };
  const auto joined = [&](const std::vector<std::string>& systems) {
    Input_properties all;
    for (const std::string& system : systems)
      add_input(of_system(system + ".las", system), all);
    return all;
  };
  CHECK(joined({"one", "one"}).las->coordinate_system.at(0).data == "one");
  CHECK(joined({"", "one", ""}).las->coordinate_system.at(0).data == "one");
  for (const std::vector<std::string>& systems :
       std::vector<std::vector<std::string>>{{"one", "other"}, {"one", "other", "one"}})
  {
    const Input_properties all = joined(systems);
    CHECK(all.las->coordinate_system.empty());
    CHECK(all.warnings.size() == 1 && all.warnings[0].find("other.las: has another") == 0);
  }
}

} // namespace

int main()
{
  test_bits_of_memory();
  test_fewer_points_than_neighbors();
  test_types_of_several_files();
  test_colors_of_several_files();
  test_whole_numbers_of_several_files();
  test_no_data_of_several_files();
  test_refusals();
  test_coordinate_systems();
  return test::result();
}
