// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Attacks the function in a child process with limits of time and memory, so that a crash or an
// endless loop is a finding too.
//
//   attack named [--every K] ...     our point sets, each with our parameter sets; every K-th pair
//   attack random RUNS [--seed S] ...  the seeds S, S + 1, ... each make one of both
//   attack large N ...               a noisy cube of N points by each method, for many threads
//   attack replay FILE... ...        the attacks that once succeeded
//   attack minimize FILE ...         writes FILE.minimal, which still breaks the same
//
// --save FOLDER      a file for each attack that succeeds
// --memory MIB       of address space for one attack; 0 for no limit, as sanitizers need it
// --json FILE        what was done
//
// Ends with 0 if no attack succeeded.

#include "Attack.h"
#include "carry_out.h"
#include "hostile.h"
#include "sandbox.h"

#include <chrono>
#include <fstream>
#include <functional>
#include <iostream>
#include <string>
#include <vector>

namespace {

using namespace attack;

struct Options
{
  std::vector<std::string> words;
  std::size_t every = 1, seed = 1;
  std::string folder, json;
  Limits limits;
};

Options parsed(int argc, char** argv)
{
  Options options;
  for (int i = 1; i < argc; ++i)
  {
    const std::string word = argv[i];
    if (word.compare(0, 2, "--") != 0)
    {
      options.words.push_back(word);
      continue;
    }
    const std::string value = i + 1 < argc ? argv[++i] : "";
    if (word == "--save")
      options.folder = value;
    else if (word == "--json")
      options.json = value;
    else if (word == "--every")
      options.every = std::stoul(value);
    else if (word == "--seed")
      options.seed = std::stoul(value);
    else if (word == "--memory")
      options.limits.bytes = std::stoul(value) << 20;
    else
      throw std::runtime_error(word + " is no option");
  }
  if (options.words.empty() || options.every == 0)
    throw std::runtime_error("named, random, large, replay or minimize expected");
  return options;
}

/// Time grows with the turns of Algorithm 1; the limits are for a hundred of them.
std::size_t patience_with(const Attack& attack)
{
  const double growths = number_of_growths(attack.parameters);
  return growths > 0 && growths <= 10000 ? 1 + std::size_t(growths / 100) : 1; // more are refused
}

/// Carries attacks out, the first `count` that `make` gives, and counts those that succeed.
/// \returns the exit status
int carry_out_all(const Options& options, std::size_t count,
                  const std::function<Attack(std::size_t)>& make)
{
  const auto start = std::chrono::steady_clock::now();
  std::size_t attacks = 0, successes = 0;
  const auto write_json = [&]() {
    if (options.json.empty())
      return;
    const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
    std::ofstream(options.json) << "{\"kind\": \"" << options.words.front()
                                << "\", \"seed\": " << options.seed << ", \"attacks\": " << attacks
                                << ", \"succeeded\": " << successes
                                << ", \"seconds\": " << time.count() << "}\n";
  };

  Sandbox sandbox([&](std::size_t i) { return carry_out(make(i)); }, options.limits);
  while (attacks < count)
  {
    const Attack attack = make(attacks);
    const std::string faults = sandbox(attacks, patience_with(attack));
    if (!faults.empty())
    {
      sandbox.end_child(); // whatever the attack has left behind
      ++successes;
      std::cerr << "failed: " << attack.name << ": " << faults << std::endl;
      if (!options.folder.empty())
        write_attack(options.folder + "/" + options.words.front() + "_"
                       + std::to_string(options.seed + attacks) + ".txt",
                     attack);
    }
    if (++attacks % 100 == 0)
      write_json(); // long campaigns may be ended at any time
  }
  std::cout << attacks << " attacks, " << successes << " succeeded" << std::endl;
  write_json();
  return attacks > 0 && successes == 0 ? 0 : 1;
}

Attack random_attack(std::size_t seed)
{
  Generator generator(seed);
  Attack attack;
  attack.name = "random " + std::to_string(seed);
  attack.points = random_point_set(generator);
  attack.normals = random_normals(attack.points.size(), generator);
  attack.parameters = random_parameters(attack.points.size(), diagonal_of(attack.points),
                                        generator);
  return attack;
}

int attack_with_named(const Options& options)
{
  Generator generator(1);
  std::vector<Attack> attacks;
  std::size_t pair = 0;
  for (const Named_points& points : hostile_point_sets())
  {
    const std::vector<Vector> normals = random_normals(points.points.size(), generator);
    for (const Named_parameters& parameters :
         hostile_parameter_sets(points.points.size(), diagonal_of(points.points)))
      if (pair++ % options.every == 0)
        attacks.push_back(
          {points.name + ", " + parameters.name, points.points, normals, parameters.parameters});
  }
  return carry_out_all(options, attacks.size(), [&](std::size_t i) { return attacks[i]; });
}

int attack_at_random(const Options& options)
{
  const std::size_t runs = std::stoul(options.words.at(1));
  std::cout << "seeds " << options.seed << " to " << options.seed + runs - 1 << std::endl;
  return carry_out_all(options, runs,
                       [&](std::size_t i) { return random_attack(options.seed + i); });
}

int attack_with_many(const Options& options)
{
  Generator generator(1);
  test::Oriented_points cube = test::cube_points(std::stoul(options.words.at(1)), 1, generator);
  test::add_gaussian_noise(cube.points, 0.01, generator);
  return carry_out_all(options, 3, [&](std::size_t method) {
    Attack attack{"large, method " + std::to_string(method), cube.points, cube.normals,
                  Parameters()};
    attack.parameters.method = int(method);
    return attack;
  });
}

int replay(const Options& options)
{
  return carry_out_all(options, options.words.size() - 1,
                       [&](std::size_t i) { return read_attack(options.words[1 + i]); });
}

/// Leaves out points and parameters as long as the faults begin with the same words.
int minimize(const Options& options)
{
  const std::string path = options.words.at(1);
  Attack attack = read_attack(path);
  const auto begin_of_faults = [&](const Attack& a) {
    Sandbox sandbox([&](std::size_t) { return carry_out(a); }, options.limits);
    return sandbox(0, patience_with(a)).substr(0, 12);
  };
  const std::string expected = begin_of_faults(attack);
  if (expected.empty())
  {
    std::cerr << path << ": nothing is broken" << std::endl;
    return 1;
  }
  const auto try_instead = [&](const Attack& other) {
    if (begin_of_faults(other) != expected)
      return false;
    attack = other;
    return true;
  };
  for (std::size_t block = attack.points.size() / 2; block > 0; block /= 2)
    for (std::size_t begin = 0; begin + block <= attack.points.size();)
    {
      Attack other = attack;
      const auto without = [&](std::vector<Vector>& v) {
        v.erase(v.begin() + std::ptrdiff_t(begin), v.begin() + std::ptrdiff_t(begin + block));
      };
      without(other.points);
      without(other.normals);
      if (!try_instead(other))
        begin += block;
    }
  for_each_parameter([&](const char*, auto member) {
    Attack other = attack;
    other.parameters.*member = Parameters().*member;
    try_instead(other);
  });
  write_attack(path + ".minimal", attack);
  std::cout << path << ".minimal has " << attack.points.size() << " points" << std::endl;
  return 0;
}

} // namespace

int main(int argc, char** argv)
{
  try
  {
    const Options options = parsed(argc, argv);
    const std::string kind = options.words.front();
    if (kind == "named")
      return attack_with_named(options);
    if (kind == "random")
      return attack_at_random(options);
    if (kind == "large")
      return attack_with_many(options);
    if (kind == "replay")
      return replay(options);
    if (kind == "minimize")
      return minimize(options);
    throw std::runtime_error(kind + " is no kind of attack");
  }
  catch (const std::exception& e)
  {
    std::cerr << "attack: " << e.what() << std::endl;
    return 2;
  }
}
