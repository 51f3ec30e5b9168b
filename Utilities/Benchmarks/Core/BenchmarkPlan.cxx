// SPDX-License-Identifier: BSD-3-Clause
// BenchmarkPlan: what the plan of a frame costs on one core, by the number of props.
//
//   a plan of 100000 props    limit 3 ms, calm and with waves
//
// A lake of 2 x 2 km seen from 30 m over it, boxes of up to 20 m anywhere on and over it, in and
// out of view, always the same ones. "BigO" is the time per prop, fitted, "RMS" how well a time
// that grows with the number fits. Times are the processor's. Exit status 1: over the limit.
#include "water_plan.h"

#include <benchmark/benchmark.h>

#include <cstdio>
#include <cstring>
#include <limits>
#include <map>
#include <random>
#include <string>
#include <vector>

namespace
{
const int MOST_PROPS = 100000;
const double LIMIT_MS = 3.0;
const unsigned SEED = 20261121;

struct Scene
{
  Scene(int count, bool hasWaves)
    : Fates(count)
  {
    std::mt19937 random(SEED);
    // not std::uniform_real_distribution, which is another one with another library
    auto next = [&](
                  double low, double high) { return low + (high - low) * random() / 4294967296.0; };
    for (int i = 0; i < count; ++i)
    {
      water_prop prop = {};
      for (int axis = 0; axis < 3; ++axis)
      {
        const double middle = axis < 2 ? next(-1000.0, 1000.0) : next(-20.0, 60.0);
        const double half = next(0.5, 10.0);
        prop.bounds[2 * axis] = middle - half;
        prop.bounds[2 * axis + 1] = middle + half;
      }
      prop.flags = WATER_PROP_VISIBLE;
      this->Props.push_back(prop);
    }
    // the eye at (0, -800, 30) looks along y, 10 degrees down; 90 degrees high and wide
    const double sine = 0.17364817766693033;
    const double cosine = 0.984807753012208;
    const double eye[3] = { 0.0, -800.0, 30.0 };
    const double rows[3][3] = { { 1.0, 0.0, 0.0 }, { 0.0, sine, cosine }, { 0.0, -cosine, sine } };
    for (int i = 0; i < 3; ++i)
    {
      for (int j = 0; j < 3; ++j)
      {
        this->Made.eye.world_to_view[4 * i + j] = rows[i][j];
        this->Made.eye.world_to_view[4 * i + 3] -= rows[i][j] * eye[j];
      }
    }
    this->Made.eye.world_to_view[15] = 1.0;
    const double nearest = 1.0;
    const double farthest = 2000.0;
    double* clip = this->Made.eye.view_to_clip;
    clip[0] = clip[5] = 1.0;
    clip[10] = -(farthest + nearest) / (farthest - nearest);
    clip[11] = -2.0 * farthest * nearest / (farthest - nearest);
    clip[14] = -1.0;
    this->Made.viewport_px[0] = this->Made.viewport_px[1] = 1000;
    this->Made.plane.normal[2] = 1.0;
    const double sheet[6] = { -1000.0, 1000.0, -1000.0, 1000.0, 0.0, 0.0 };
    std::memcpy(this->Made.surface_bounds, sheet, sizeof sheet);
    this->Made.look.index_of_refraction = 1.333;
    this->Made.settings.texture_scale = 1.0;
    this->Made.max_texture_px = 16384;
    this->Made.max_samples = 32;
    this->Made.settings.skips = WATER_MAY_SKIP_ALL;
    this->Made.props = this->Props.data();
    this->Made.prop_count = this->Props.size();
    this->Made.has_waves = hasWaves;
    this->Made.slope_max = std::numeric_limits<double>::infinity();
    this->Made.slope_rms = hasWaves ? 0.05 : 0.0;
    this->Made.wave_height_max = hasWaves ? 0.5 : 0.0;
  }

  std::vector<water_prop> Props;
  std::vector<water_cull_reason> Fates;
  water_scene Made = {};
};

void Plan(benchmark::State& state, bool hasWaves)
{
  Scene scene(static_cast<int>(state.range(0)), hasWaves);
  water_plan plan;
  for (auto _ : state)
  {
    if (water_plan_make(&scene.Made, &plan, scene.Fates.data()) != WATER_OK ||
      plan.decision != WATER_REFLECT)
    {
      state.SkipWithError("the scene was not planned");
      break;
    }
    benchmark::DoNotOptimize(plan);
    benchmark::ClobberMemory();
  }
  std::size_t drawn = 0;
  for (const water_cull_reason fate : scene.Fates)
  {
    drawn += fate == WATER_CULL_NONE;
  }
  state.counters["drawn"] = static_cast<double>(drawn);
  state.SetComplexityN(state.range(0));
}

// Prints as always, and keeps the times of the most props.
class Reporter : public benchmark::ConsoleReporter
{
public:
  Reporter()
    : ConsoleReporter(OO_Tabular) // no colours: the output goes into files, too
  {
  }

  void ReportRuns(const std::vector<Run>& runs) override
  {
    this->ConsoleReporter::ReportRuns(runs);
    for (const Run& run : runs)
    {
      this->HasFailed = this->HasFailed || run.error_occurred;
      if (run.run_type == Run::RT_Iteration && run.complexity_n == MOST_PROPS)
      {
        this->Milliseconds[run.run_name.function_name] =
          1e3 * run.cpu_accumulated_time / static_cast<double>(run.iterations);
      }
    }
  }

  std::map<std::string, double> Milliseconds;
  bool HasFailed = false;
};
}

BENCHMARK_CAPTURE(Plan, calm, false)
  ->Unit(benchmark::kMicrosecond)
  ->Arg(10)
  ->Arg(1000)
  ->Arg(MOST_PROPS)
  ->Complexity(benchmark::oN);
BENCHMARK_CAPTURE(Plan, waves, true)
  ->Unit(benchmark::kMicrosecond)
  ->Arg(10)
  ->Arg(1000)
  ->Arg(MOST_PROPS)
  ->Complexity(benchmark::oN);

int main(int argc, char** argv)
{
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv))
  {
    return 2;
  }
  Reporter reporter;
  benchmark::RunSpecifiedBenchmarks(&reporter);
  bool isGood = !reporter.HasFailed;
  for (const auto& [name, milliseconds] : reporter.Milliseconds)
  {
    const bool holds = milliseconds < LIMIT_MS;
    std::printf("%s, %d props: %.3f ms (limit %.0f ms) %s\n", name.c_str(), MOST_PROPS,
      milliseconds, LIMIT_MS, holds ? "ok" : "FAILED");
    isGood = isGood && holds;
  }
  return isGood ? 0 : 1;
}
