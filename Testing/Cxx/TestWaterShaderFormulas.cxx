// SPDX-License-Identifier: BSD-3-Clause
// What the shaders' functions compute on this driver is what the core's compute, to the roundings
// of a float.
//
// An error is counted in roundings: 2^-24 of the result's own scale, and what such a rounding of
// each input does to the core's result, so that a formula may be as bad as its inputs are, where a
// square root begins or many radians are taken off an angle.
#include "WaterShaderRun.h"
#include "WaterTestScene.h"

#include "vtkWaterGLSL.h"
#include "water_medium.h"
#include "water_shared.h"
#include "water_waves.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>

namespace
{
constexpr double kRounding = 1.0 / (1 << 24);
constexpr double kWaveLimit = 64.0; // each of several waves has roundings of its own
constexpr int kInputs = 4 * WaterShaderRun::TexelsPerCase;

using Inputs = std::array<double, kInputs>;
using Outputs = std::array<double, 4>;

struct Formula
{
  std::string Name;
  std::string Files;      // of the shaders, in order
  std::string Expression; // a vec4, of testCase(i)
  int Count;              // of the inputs
  double Limit;           // roundings
  std::function<void(Inputs&)> Draw;
  std::function<Outputs(const Inputs&)> Core;
  std::function<double(const Outputs&)> Scale;
  // The expression is that of a vertex shader.
  bool IsOfVertices = false;
  // Results under that may be 0: floats end at 1e-38.
  double Least = 1e-37;
};

std::mt19937 generator(1); // the same numbers everywhere

// In [low, high]; the ends themselves now and then.
double Between(double low, double high)
{
  const double part = static_cast<double>(generator()) / 4294967295.0;
  return part < 0.01 ? low : (part > 0.99 ? high : low + part * (high - low));
}

// The same, evenly over the orders of magnitude.
double Magnitude(double low, double high)
{
  return std::exp(Between(std::log(low), std::log(high)));
}

void DrawDirection(double* dir)
{
  const double z = Between(-1.0, 1.0);
  const double turn = Between(0.0, 6.2831853);
  const double across = std::sqrt(1.0 - z * z);
  dir[0] = across * std::cos(turn);
  dir[1] = across * std::sin(turn);
  dir[2] = z;
}

double LargestOf(const Outputs& values)
{
  double largest = 0.0;
  for (double value : values)
  {
    largest = std::max(largest, std::abs(value));
  }
  return largest;
}

// What a rounding of each input does to the result. Some roundings at once: a jump that is so near
// counts, too.
Outputs Sensitivity(const Formula& formula, const Inputs& inputs, const Outputs& right)
{
  constexpr double steps = 4.0;
  Outputs sum{};
  for (int i = 0; i < formula.Count; ++i)
  {
    Outputs most{};
    for (double sign : { -1.0, 1.0 })
    {
      Inputs moved = inputs;
      moved[i] *= 1.0 + sign * steps * kRounding;
      const Outputs other = formula.Core(moved);
      for (size_t j = 0; j < most.size(); ++j)
      {
        most[j] = std::max(most[j], std::abs(other[j] - right[j]) / steps);
      }
    }
    for (size_t j = 0; j < most.size(); ++j)
    {
      sum[j] += most[j];
    }
  }
  return sum;
}

bool Check(WaterShaderRun& run, const Formula& formula, const std::vector<float>& waves,
  const std::function<void(GLuint)>& setUniforms)
{
  std::vector<float> cases(kInputs * WaterShaderRun::CaseCount);
  std::vector<Inputs> all(WaterShaderRun::CaseCount);
  for (int number = 0; number < WaterShaderRun::CaseCount; ++number)
  {
    Inputs inputs{};
    formula.Draw(inputs);
    // a case's texels lie below each other
    const int column = number % WaterShaderRun::Width;
    const int row = number / WaterShaderRun::Width * WaterShaderRun::TexelsPerCase;
    for (int i = 0; i < kInputs; ++i)
    {
      const float single = static_cast<float>(inputs[i]);
      all[number][i] = single;
      cases[4 * ((row + i / 4) * WaterShaderRun::Width + column) + i % 4] = single;
    }
  }

  std::string vertex = WaterShaderRun::VertexDeclarations();
  std::string fragment = WaterShaderRun::FragmentDeclarations();
  if (formula.IsOfVertices)
  {
    vertex += "out vec4 testVSOutput;\n" + formula.Files +
      "void main()\n{\n  testVSOutput = " + formula.Expression +
      ";\n  gl_Position = testVertex();\n}\n";
    fragment += "in vec4 testVSOutput;\nvoid main()\n{\n  testResult = testVSOutput;\n}\n";
  }
  else
  {
    vertex += "void main()\n{\n  gl_Position = testVertex();\n}\n";
    fragment += formula.Files + "void main()\n{\n  testResult = " + formula.Expression + ";\n}\n";
  }
  const std::vector<float> results = run.Run(vertex, fragment, cases, waves, setUniforms);
  if (results.empty())
  {
    std::cout << formula.Name << ": does not run FAILED" << std::endl;
    return false;
  }

  double largest = 0.0;
  size_t worst = 0;
  for (size_t number = 0; number < all.size(); ++number)
  {
    const Outputs right = formula.Core(all[number]);
    const Outputs sensitivity = Sensitivity(formula, all[number], right);
    const double scale = kRounding * formula.Scale(right);
    for (size_t j = 0; j < right.size(); ++j)
    {
      const double found = results[4 * number + j];
      const double error = std::max(std::abs(found - right[j]) - formula.Least, 0.0);
      double roundings = error > 0.0 ? error / (scale + sensitivity[j]) : 0.0;
      if (!std::isfinite(found) || !std::isfinite(roundings))
      {
        roundings = std::numeric_limits<double>::infinity();
      }
      if (roundings > largest)
      {
        largest = roundings;
        worst = number;
      }
    }
  }
  const bool holds = largest <= formula.Limit;
  std::cout << formula.Name << ": largest error, roundings: " << largest
            << " (limit <= " << formula.Limit << ") " << (holds ? "ok" : "FAILED") << ", at";
  for (int i = 0; i < formula.Count; ++i)
  {
    std::cout << " " << all[worst][i];
  }
  std::cout << std::endl;
  return holds;
}

void DrawRay(Inputs& inputs)
{
  inputs[0] = Between(0.0, 1.0);
  inputs[1] = generator() % 4 ? Between(0.4, 2.5) : (generator() % 2 ? 1.333 : 1.0 / 1.333);
}

double OfUnit(const Outputs&)
{
  return 1.0;
}

std::vector<Formula> MakeScalars()
{
  std::vector<Formula> formulas;
  formulas.push_back({ "Fresnel", vtkWaterOptics,
    "vec4(waterFresnel(testCase(0).x, testCase(0).y))", 2, 8.0, DrawRay,
    [](const Inputs& in) {
      const double value = water_shared_fresnel(in[0], in[1]);
      return Outputs{ value, value, value, value };
    },
    OfUnit });
  formulas.push_back({ "Schlick", vtkWaterOptics,
    "vec4(waterSchlick(testCase(0).x, testCase(0).y))", 2, 8.0, DrawRay,
    [](const Inputs& in) {
      const double value = water_shared_schlick(in[0], in[1]);
      return Outputs{ value, value, value, value };
    },
    OfUnit });
  formulas.push_back({ "transmittance", vtkWaterAttenuation,
    "vec4(waterTransmittance(testCase(0).x, testCase(0).y))", 2, 8.0,
    [](Inputs& in) {
      in[0] = generator() % 16 ? Magnitude(1e-3, 20.0) : 0.0;
      in[1] = Magnitude(1e-3, 1e9);
    },
    [](const Inputs& in) {
      const double value = water_shared_transmittance(in[0], in[1]);
      return Outputs{ value, value, value, value };
    },
    OfUnit });
  formulas.push_back({ "haze of particles", vtkWaterHaze, "vec4(waterHazeParticles(testCase(0).x))",
    1, 64.0, [](Inputs& in) { in[0] = Between(-1.0, 1.0); },
    [](const Inputs& in) {
      const double value = water_shared_haze_particles(in[0]);
      return Outputs{ value, value, value, value };
    },
    [](const Outputs& right) { return std::abs(right[0]); } });
  formulas.push_back({ "haze over a way", vtkWaterHaze,
    "vec4(waterHazeOver(testCase(0).x, testCase(0).y, testCase(0).z, testCase(0).w, "
    "testCase(1).x))",
    5, 256.0, // a difference of exponentials over a small rate
    [](Inputs& in) {
      in[0] = Magnitude(1e-3, 2.0);
      in[1] = in[0] * Between(1.0, 1.5);
      in[2] = Between(-1.0, 1.0);
      in[3] = Magnitude(1e-2, 1e2);
      in[4] = Magnitude(1e-2, 1e3);
    },
    [](const Inputs& in) {
      const double value = water_shared_haze_over(in[0], in[1], in[2], in[3], in[4]);
      return Outputs{ value, value, value, value };
    },
    OfUnit });
  formulas.push_back({ "density of slopes", vtkWaterSlopes,
    "vec4(waterSlopeDensity(testCase(0).x, testCase(0).y, testCase(0).z, testCase(0).w, "
    "testCase(1).x, testCase(1).y))",
    6, 16.0,
    [](Inputs& in) {
      in[0] = Magnitude(2e-5, 0.3);
      in[1] = in[0] * Magnitude(0.1, 10.0);
      in[2] = Between(-0.9, 0.9) * std::sqrt(in[0] * in[1]);
      in[3] = in[0] * in[1] - in[2] * in[2];
      in[4] = Between(-5.0, 5.0) * std::sqrt(in[0]);
      in[5] = Between(-5.0, 5.0) * std::sqrt(in[1]);
    },
    [](const Inputs& in) {
      const double value = water_shared_slope_density(in[0], in[1], in[2], in[3], in[4], in[5]);
      return Outputs{ value, value, value, value };
    },
    LargestOf, false, 1e-32 }); // a power of 1e-37 over the least root of an area
  formulas.push_back({ "area of facets", vtkWaterSlopes,
    "vec4(waterFacingArea(testCase(0).x, testCase(0).y))", 2, 64.0,
    [](Inputs& in) {
      in[0] = Magnitude(1e-3, 1.0);
      in[1] = Magnitude(1e-3, 1.0);
    },
    [](const Inputs& in) {
      const double value = water_shared_facing_area(in[0], in[1]);
      return Outputs{ value, value, value, value };
    },
    LargestOf });
  formulas.push_back({ "spread of glitter", vtkWaterSlopes,
    "vec4(waterGlitterSpread(testCase(0).x, testCase(0).y))", 2, 8.0,
    [](Inputs& in) {
      in[0] = Magnitude(1e-3, 1.0);
      in[1] = Magnitude(1e-6, 1.0);
    },
    [](const Inputs& in) {
      const double value = water_shared_glitter_spread(in[0], in[1]);
      return Outputs{ value, value, value, value };
    },
    LargestOf });
  formulas.push_back({ "highlights", vtkWaterHighlights, "vec4(waterRollOff(testCase(0).x))", 1,
    8.0, [](Inputs& in) { in[0] = Magnitude(1e-3, 1e4); },
    [](const Inputs& in) {
      const double value = water_shared_roll_off(in[0]);
      return Outputs{ value, value, value, value };
    },
    OfUnit });
  formulas.push_back({ "foam of a shore", vtkWaterFoamCover,
    "vec4(waterShoreFoam(testCase(0).x, testCase(0).y))", 2, 64.0,
    [](Inputs& in) {
      in[0] = Between(0.0, 2.0);
      in[1] = Between(0.0, 1.0);
    },
    [](const Inputs& in) {
      const double value = water_shared_shore_foam(in[0], in[1]);
      return Outputs{ value, value, value, value };
    },
    OfUnit });
  formulas.push_back(
    { "threshold of foam", vtkWaterFoamCover, "vec4(waterFoamThreshold(testCase(0).x))", 1, 64.0,
      [](Inputs& in) { in[0] = generator() % 16 ? Between(0.0, 1.0) : 0.0; },
      [](const Inputs& in) {
        const double value = water_shared_foam_threshold(in[0]);
        return Outputs{ value, value, value, value };
      },
      OfUnit });
  formulas.push_back({ "foam of a measure", vtkWaterFoamMeasure,
    "vec4(waterFoamOfMeasure(testCase(0).x, testCase(0).y, testCase(0).z))", 3, 16.0,
    [](Inputs& in) {
      in[0] = Between(0.0, 2.0);
      in[1] = Between(0.0, 1.0);
      in[2] = in[1] + Between(0.3, 1.0);
    },
    [](const Inputs& in) {
      const double value = water_shared_foam_of_measure(in[0], in[1], in[2]);
      return Outputs{ value, value, value, value };
    },
    OfUnit });
  formulas.push_back({ "coefficient of water with matter", vtkWaterMatter,
    "vec4(waterWithMatter(testCase(0).x, testCase(0).y, testCase(0).z))", 3, 8.0,
    [](Inputs& in) {
      in[0] = Magnitude(1e-4, 1e2);
      in[1] = Magnitude(1e-4, 1e2);
      in[2] = generator() % 16 ? Magnitude(1e-3, 1e4) : 0.0;
    },
    [](const Inputs& in) {
      const double value = water_shared_with_matter(in[0], in[1], in[2]);
      return Outputs{ value, value, value, value };
    },
    LargestOf });
  formulas.push_back({ "color of deep water", vtkWaterMatter,
    "vec4(waterEncoded(testCase(0).x * waterSentBack(testCase(0).y, testCase(0).z)))", 3, 64.0,
    [](Inputs& in) {
      in[0] = Between(0.0, 4.0);
      in[1] = Magnitude(1e-3, 1.0);
      in[2] = in[1] + (generator() % 16 ? Magnitude(1e-3, 1.0) : 0.0);
    },
    [](const Inputs& in) {
      const double value = water_shared_encoded(in[0] * water_shared_sent_back(in[1], in[2]));
      return Outputs{ value, value, value, value };
    },
    OfUnit });
  formulas.push_back({ "gain of layers", vtkWaterFlowGain,
    "vec4(waterFlowGain(testCase(0).x, testCase(0).y, testCase(0).z))", 3, 16.0,
    [](Inputs& in) {
      in[0] = Between(0.0, 1.0);
      in[1] = generator() % 16 ? Magnitude(1e-3, 1e3) : 0.0;
      in[2] = Magnitude(1e-2, 1e2);
    },
    [](const Inputs& in) {
      const double value = water_shared_flow_gain(in[0], in[1], in[2]);
      return Outputs{ value, value, value, value };
    },
    OfUnit });
  formulas.push_back({ "gain of layers of a band", vtkWaterFlowGain,
    "vec4(waterFlowBandGain(testCase(0).x, testCase(0).y, testCase(0).z, testCase(1).x))", 5, 64.0,
    [](Inputs& in) {
      in[0] = Between(0.0, 1.0);
      in[1] = generator() % 16 ? Magnitude(1e-3, 1e3) : 0.0;
      in[2] = Magnitude(1e-2, 1e2);
      in[4] = in[2] * Between(1.5, 100.0);
    },
    [](const Inputs& in) {
      const double value = water_shared_flow_band_gain(in[0], in[1], in[2], in[4]);
      return Outputs{ value, value, value, value };
    },
    OfUnit });
  formulas.push_back({ "height of the gradient", vtkWaterGradient,
    "vec4(waterGradientHeight(testCase(0).x, testCase(0).y))", 2, 8.0,
    [](Inputs& in) {
      in[0] = Between(-2.0, 2.0);
      in[1] = generator() % 16 ? Between(-1.0, 2.0) : 0.0;
    },
    [](const Inputs& in) {
      const double value = water_shared_gradient_height(in[0], in[1]);
      return Outputs{ value, value, value, value };
    },
    OfUnit });
  return formulas;
}

Formula MakeRefraction()
{
  // as vtkWaterMediumFS.glsl asks for it
  return { "refraction", "",
    "vec4(refract(testCase(0).xyz, testCase(1).xyz, 1.0 / testCase(0).w), 0.0)", 7, 8.0,
    [](Inputs& in) {
      DrawDirection(in.data());
      DrawDirection(in.data() + 4);
      // the normal is towards the ray
      const double along = in[0] * in[4] + in[1] * in[5] + in[2] * in[6];
      for (int i = 4; i < 7 && along > 0.0; ++i)
      {
        in[i] = -in[i];
      }
      Inputs ray{};
      DrawRay(ray);
      in[3] = ray[1];
    },
    [](const Inputs& in) {
      Outputs out{};
      water_medium_refract(in.data(), in.data() + 4, in[3], out.data()); // 0 if it is reflected
      return out;
    },
    OfUnit };
}

// Waves, and what shaders know of them, near a point far from the origin.
struct Waves
{
  static constexpr double Origin[2] = { 12345.0, -6789.0 };

  Waves(double steepness, double strength)
  {
    std::vector<water_wave> waves;
    for (int i = 0; i < 8; ++i)
    {
      const double wavelength = 40.0 * std::pow(0.6, i);
      waves.push_back({ strength * 0.01 * wavelength, wavelength, 0.7 * i, 1.3 * i, steepness });
    }
    this->Terms.resize(waves.size());
    size_t bad = 0;
    if (water_waves_at(waves.data(), waves.size(), 10.0, 100.0, this->Terms.data(), &bad) !=
      WATER_OK)
    {
      std::cout << "wave " << bad << " FAILED" << std::endl;
    }
    std::vector<water_wave_row> rows(waves.size());
    water_waves_rows(this->Terms.data(), rows.size(), Origin[0], Origin[1], rows.data());
    for (const water_wave_row& row : rows)
    {
      this->Rows.insert(this->Rows.end(),
        { row.k[0], row.k[1], row.amplitude, row.phase, row.steepness, 0.0f, 0.0f, 0.0f });
      this->Height += row.amplitude;
      this->Slope += row.amplitude * std::hypot(row.k[0], row.k[1]);
    }
  }

  water_wave_point GetPoint(const Inputs& in) const
  {
    water_wave_point point;
    water_waves_point(
      this->Terms.data(), this->Terms.size(), Origin[0] + in[0], Origin[1] + in[1], &point);
    return point;
  }

  water_wave_point Find(const Inputs& in) const
  {
    water_wave_point point{};
    double rest[2];
    water_waves_find(
      this->Terms.data(), this->Terms.size(), Origin[0] + in[0], Origin[1] + in[1], rest, &point);
    return point;
  }

  std::vector<water_wave_term> Terms;
  std::vector<float> Rows;
  double Height = 0.0; // the most
  double Slope = 0.0;
};

void DrawPlace(Inputs& in)
{
  in[0] = Between(-200.0, 200.0);
  in[1] = Between(-200.0, 200.0);
}

bool CheckWaves(WaterShaderRun& run, const std::string& name, double steepness, double strength)
{
  const Waves waves(steepness, strength);
  const int steps = water_waves_rest_steps(false, steepness > 0.0);
  const auto setUniforms = [&](GLuint program) {
    const float identity[16] = { 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1 };
    const float identity3[9] = { 1, 0, 0, 0, 1, 0, 0, 0, 1 };
    glUniform1i(
      glGetUniformLocation(program, "waterWaveCount"), static_cast<int>(waves.Terms.size()));
    glUniform1i(glGetUniformLocation(program, "waterRestSteps"), steps);
    glUniformMatrix4fv(glGetUniformLocation(program, "waterAxesToClip"), 1, GL_FALSE, identity);
    glUniformMatrix3fv(glGetUniformLocation(program, "waterClipToPlace"), 1, GL_FALSE, identity3);
    glUniform4f(glGetUniformLocation(program, "waterHeightOfClip"), 0.0f, 0.0f, 1.0f, 0.0f);
  };
  Formula moved{ name + ", displacement",
    std::string(vtkWaterCell) + vtkWaterNoSeaVS + vtkWaterDisplacementVS +
      "vec4 testMoved(vec2 place)\n{\n  vec4 position = vec4(place, 0.0, 1.0);\n"
      "  waterDisplace(position);\n  return vec4(waterMovedVSOutput, 0.0);\n}\n",
    "testMoved(testCase(0).xy)", 2, kWaveLimit, DrawPlace,
    [&](const Inputs& in) {
      const water_wave_point point = waves.GetPoint(in);
      return Outputs{ point.displacement[0], point.displacement[1], point.displacement[2], 0.0 };
    },
    [&](const Outputs&) { return waves.Height; } };
  moved.IsOfVertices = true;
  const Formula slope{ name + ", slope over a place",
    std::string(vtkWaterGradient) + vtkWaterNoDisplacementFS + vtkWaterPixelHeightFS +
      vtkWaterPointFS + vtkWaterPixelFS + vtkWaterWavesFS +
      "vec4 testSlope(vec2 place)\n{\n  vec4 variance = vec4(0.0);\n  float jacobian;\n"
      "  vec2 slope = waterSlope(place, vec2(0.0), vec2(0.0), vec3(0.0), variance, jacobian);\n"
      "  return vec4(slope, jacobian, variance.x);\n}\n",
    "testSlope(testCase(0).xy)", 2, kWaveLimit, DrawPlace,
    [&](const Inputs& in) {
      const water_wave_point point = waves.Find(in);
      return Outputs{ point.slope[0], point.slope[1], point.jacobian, 0.0 };
    },
    [&](const Outputs& right) { return std::max(waves.Slope, std::abs(right[2])); } };
  return static_cast<int>(Check(run, moved, waves.Rows, setUniforms)) &
    static_cast<int>(Check(run, slope, waves.Rows, setUniforms));
}
}

int TestWaterShaderFormulas(int, char*[])
{
  WaterShaderRun run;
  const std::vector<float> noWaves(8, 0.0f);
  const auto setNothing = [](GLuint) {};
  bool ok = true;
  for (const Formula& formula : MakeScalars())
  {
    ok &= Check(run, formula, noWaves, setNothing);
  }
  ok &= Check(run, MakeRefraction(), noWaves, setNothing);
  ok &= CheckWaves(run, "sine waves", 0.0, 1.0);
  ok &= CheckWaves(run, "Gerstner waves", 0.6, 1.0);
  return ok ? EXIT_SUCCESS : EXIT_FAILURE;
}
