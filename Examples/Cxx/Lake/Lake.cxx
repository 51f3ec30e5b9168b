// SPDX-License-Identifier: BSD-3-Clause
// Lake.cxx: floods a real elevation model, renders it off-screen and prints what was reflected.
//
// The same picture as Examples/Python/lake.py. Lengths are in metres.
// Flow: read -> refine -> colour and tile -> flood -> render.
#include <vtkActor.h>
#include <vtkArrayCalculator.h>
#include <vtkAssignAttribute.h>
#include <vtkCamera.h>
#include <vtkColorTransferFunction.h>
#include <vtkErrorCode.h>
#include <vtkExtractVOI.h>
#include <vtkImageCast.h>
#include <vtkImageData.h>
#include <vtkImageDataGeometryFilter.h>
#include <vtkImageResample.h>
#include <vtkLight.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkPolyDataNormals.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkTriangleFilter.h>
#include <vtkWarpScalar.h>
#include <vtkWaterActor.h>
#include <vtkWaterOffScreen.h>
#include <vtkWaterReflectionPass.h>
#include <vtkWindowToImageFilter.h>
#include <vtkXMLImageDataReader.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <iomanip>
#include <iostream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace
{
const char* const USAGE =
  "usage: Lake [elevation] [folder] [level]\n"
  "\n"
  "Floods a real elevation model, renders it off-screen and prints what was reflected.\n"
  "\n"
  "  elevation  elevation model, a .vti file with heights in metres (" LAKE_DATA_FOLDER
  "/jacksboro.vti)\n"
  "  folder     where lake.png goes; made when missing (.)\n"
  "  level      water level in metres (384)\n";

struct Options
{
  std::string Elevation = LAKE_DATA_FOLDER "/jacksboro.vti";
  std::filesystem::path Folder = ".";
  double Level = 384.0;
};

const double EXAGGERATION = 2.0; // heights are drawn this many times higher than they are
const int REFINEMENT = 2;        // points drawn per point of the elevation model, along each axis
const int TILES = 4; // the terrain is TILES x TILES props, so that those out of view cost nothing
const int SIZE[2] = { 1280, 720 };
const int SAMPLES = 8;
const int FRAMES = 3; // timed, of each kind

// The camera stands over the lake: fractions of the map's extent, east and north, and metres drawn.
const double EYE[2] = { 0.831, 0.233 };
const double TARGET[2] = { 0.530, 0.122 };
const double EYE_HEIGHT = 150.0;    // above the water, or above the ground where that is higher
const double TARGET_HEIGHT = 200.0; // above the water
const double VIEW_ANGLE_DEG = 32.0;
const double SUN_AZIMUTH_DEG = 120.0;
const double SUN_ELEVATION_DEG = 24.0;

// Ground colours by height in metres; steep ground counts as up to STEEPNESS metres higher, which
// brings the rock out. Sand, meadow, forest, grass, rock, snow.
const double STEEPNESS = 500.0;
const double COLORS[][4] = {
  { 200.0, 0.40, 0.36, 0.27 },
  { 398.0, 0.42, 0.38, 0.28 },
  { 412.0, 0.30, 0.34, 0.19 },
  { 600.0, 0.25, 0.32, 0.18 },
  { 750.0, 0.31, 0.32, 0.19 },
  { 880.0, 0.45, 0.41, 0.34 },
  { 1000.0, 0.66, 0.64, 0.61 },
  { 1100.0, 0.90, 0.90, 0.91 },
};
const double SKY_AT_BOTTOM[3] = { 1.00, 0.97, 0.90 };
const double SKY_AT_TOP[3] = { 0.24, 0.46, 0.74 };

// What ends the program: said on standard error, exit code 1 (2 when it was called wrongly).
struct UsageError : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

Options ReadOptions(const std::vector<std::string>& arguments)
{
  Options options;
  for (const std::string& argument : arguments)
  {
    if (argument == "-h" || argument == "--help")
    {
      std::cout << USAGE;
      std::exit(EXIT_SUCCESS);
    }
  }
  if (arguments.size() > 3)
  {
    throw UsageError("more than 3 arguments");
  }
  if (arguments.size() > 0)
  {
    options.Elevation = arguments[0];
  }
  if (arguments.size() > 1)
  {
    options.Folder = arguments[1];
  }
  if (arguments.size() > 2)
  {
    std::istringstream text(arguments[2]);
    if (!(text >> options.Level) || !text.eof())
    {
      throw UsageError(arguments[2] + ": the level must be a number of metres");
    }
  }
  return options;
}

vtkSmartPointer<vtkImageData> ReadElevation(const std::string& file)
{
  if (std::filesystem::is_directory(file))
  {
    throw std::runtime_error(
      file + ": is a folder, not a file; the folder for the picture comes second");
  }
  if (!std::filesystem::is_regular_file(file))
  {
    throw std::runtime_error(file + ": no such file");
  }
  vtkNew<vtkXMLImageDataReader> reader;
  if (!reader->CanReadFile(file.c_str()))
  {
    throw std::runtime_error(file + ": not a VTK image (.vti)");
  }
  reader->SetFileName(file.c_str());
  reader->Update();
  vtkSmartPointer<vtkImageData> image = reader->GetOutput();
  if (image->GetNumberOfPoints() < 4 || !image->GetPointData()->GetScalars())
  {
    throw std::runtime_error(file + ": holds no elevations");
  }
  return image;
}

// Triangles over the heights that the source yields.
vtkSmartPointer<vtkTriangleFilter> MakeSurface(vtkAlgorithm* source)
{
  vtkNew<vtkImageDataGeometryFilter> geometry;
  geometry->SetInputConnection(source->GetOutputPort());
  vtkNew<vtkWarpScalar> warp;
  warp->SetInputConnection(geometry->GetOutputPort());
  warp->SetNormal(0.0, 0.0, 1.0);
  warp->UseNormalOn(); // this one, not the ground's
  warp->SetScaleFactor(EXAGGERATION);
  auto triangles = vtkSmartPointer<vtkTriangleFilter>::New();
  triangles->SetInputConnection(warp->GetOutputPort());
  return triangles;
}

// The same heights on a finer grid, smoothly, with the normals and colours of the ground.
vtkSmartPointer<vtkImageData> Refine(vtkImageData* elevation)
{
  vtkNew<vtkImageCast> cast;
  cast->SetOutputScalarTypeToFloat();
  cast->SetInputData(elevation);
  vtkNew<vtkImageResample> resample;
  resample->SetInputConnection(cast->GetOutputPort());
  resample->SetInterpolationModeToCubic();
  resample->SetAxisMagnificationFactor(0, REFINEMENT);
  resample->SetAxisMagnificationFactor(1, REFINEMENT);

  auto surface = MakeSurface(resample);
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputConnection(surface->GetOutputPort());
  normals->SplittingOff(); // keeps the points, and their order
  vtkNew<vtkArrayCalculator> cover;
  cover->SetInputConnection(normals->GetOutputPort());
  cover->AddCoordinateScalarVariable("z", 2);
  cover->AddScalarVariable("up", "Normals", 2);
  std::ostringstream function;
  function << "z / " << EXAGGERATION << " + " << STEEPNESS << " * (1 - up)";
  cover->SetFunction(function.str().c_str());
  cover->SetResultArrayName("cover");
  cover->Update();

  auto image = vtkSmartPointer<vtkImageData>::New();
  image->ShallowCopy(resample->GetOutput());
  for (const char* name : { "Normals", "cover" })
  {
    image->GetPointData()->AddArray(
      vtkPolyData::SafeDownCast(cover->GetOutput())->GetPointData()->GetArray(name));
  }
  return image;
}

// The ground: an actor a tile.
std::vector<vtkSmartPointer<vtkActor>> MakeTerrain(vtkImageData* image)
{
  vtkNew<vtkColorTransferFunction> colors;
  for (const double(&stop)[4] : COLORS)
  {
    colors->AddRGBPoint(stop[0], stop[1], stop[2], stop[3]);
  }
  const int* size = image->GetDimensions();
  const auto border = [](int count, int tile) { return (count - 1) * tile / TILES; };
  std::vector<vtkSmartPointer<vtkActor>> actors;
  for (int row = 0; row < TILES; ++row)
  {
    for (int column = 0; column < TILES; ++column)
    {
      vtkNew<vtkExtractVOI> tile;
      tile->SetInputData(image);
      tile->SetVOI(border(size[0], column), border(size[0], column + 1), border(size[1], row),
        border(size[1], row + 1), 0, 0);
      auto surface = MakeSurface(tile);
      vtkNew<vtkAssignAttribute> shading; // warping does not keep normals as such
      shading->SetInputConnection(surface->GetOutputPort());
      shading->Assign("Normals", "NORMALS", "POINT_DATA");
      vtkNew<vtkPolyDataMapper> mapper;
      mapper->SetInputConnection(shading->GetOutputPort());
      mapper->SetScalarModeToUsePointFieldData();
      mapper->SelectColorArray("cover");
      mapper->SetLookupTable(colors);
      mapper->UseLookupTableScalarRangeOn();
      auto actor = vtkSmartPointer<vtkActor>::New();
      actor->SetMapper(mapper);
      actor->GetProperty()->SetAmbient(0.25);
      actor->GetProperty()->SetDiffuse(1.0);
      actors.push_back(actor);
    }
  }
  return actors;
}

vtkSmartPointer<vtkLight> MakeSun()
{
  const double azimuth = vtkMath::RadiansFromDegrees(SUN_AZIMUTH_DEG);
  const double elevation = vtkMath::RadiansFromDegrees(SUN_ELEVATION_DEG);
  auto sun = vtkSmartPointer<vtkLight>::New();
  sun->SetLightTypeToSceneLight();
  sun->SetPosition(std::sin(azimuth) * std::cos(elevation), std::cos(azimuth) * std::cos(elevation),
    std::sin(elevation));
  sun->SetFocalPoint(0.0, 0.0, 0.0);
  sun->SetColor(1.0, 0.95, 0.86);
  return sun;
}

void PlaceCamera(vtkRenderer* renderer, vtkImageData* elevation, double level)
{
  const double* bounds = elevation->GetBounds();
  const auto east = [bounds](const double fraction[2]) {
    return bounds[0] + fraction[0] * (bounds[1] - bounds[0]);
  };
  const auto north = [bounds](const double fraction[2]) {
    return bounds[2] + fraction[1] * (bounds[3] - bounds[2]);
  };

  const double ground = elevation->GetPointData()->GetScalars()->GetTuple1(
    elevation->FindPoint(east(EYE), north(EYE), bounds[4]));
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetPosition(east(EYE), north(EYE), EXAGGERATION * std::max(level, ground) + EYE_HEIGHT);
  camera->SetFocalPoint(east(TARGET), north(TARGET), EXAGGERATION * level + TARGET_HEIGHT);
  camera->SetViewUp(0.0, 0.0, 1.0);
  camera->SetViewAngle(VIEW_ANGLE_DEG);
  renderer->ResetCameraClippingRange();
  // VTK's choice for such a wide scene would cut the nearest water away.
  camera->SetClippingRange(0.25 * EYE_HEIGHT, camera->GetClippingRange()[1]);
}

// Median time of a frame in milliseconds; the first, which sets things up, does not count.
double MeasureFrame(vtkRenderWindow* window)
{
  std::vector<double> times_ms;
  for (int i = 0; i < FRAMES + 1; ++i)
  {
    const auto start = std::chrono::steady_clock::now();
    window->Render();
    window->WaitForCompletion();
    const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - start;
    times_ms.push_back(time.count());
  }
  std::sort(times_ms.begin() + 1, times_ms.end());
  return times_ms[1 + FRAMES / 2];
}

void WritePNG(vtkRenderWindow* window, const std::filesystem::path& file)
{
  vtkNew<vtkWindowToImageFilter> capture;
  capture->SetInput(window);
  capture->ReadFrontBufferOff();
  capture->ShouldRerenderOff();
  vtkNew<vtkPNGWriter> writer;
  writer->SetFileName(file.string().c_str());
  writer->SetInputConnection(capture->GetOutputPort());
  writer->Write();
  if (writer->GetErrorCode() != vtkErrorCode::NoError || !std::filesystem::is_regular_file(file))
  {
    throw std::runtime_error(file.string() + ": cannot write");
  }
}

// What was reflected and what was left out, with the reasons.
std::string DescribeFates(vtkWaterReflectionPass* reflection)
{
  std::ostringstream text;
  for (int fate = 0; fate < vtkWaterReflectionPass::NUMBER_OF_FATES; ++fate)
  {
    if (reflection->GetFateCount(fate) > 0)
    {
      text << (text.str().empty() ? "" : ", ") << reflection->GetFateCount(fate) << " "
           << vtkWaterReflectionPass::GetFateAsString(fate);
    }
  }
  return text.str().empty() ? "none" : text.str();
}

void Run(const Options& options)
{
  vtkSmartPointer<vtkImageData> elevation = ReadElevation(options.Elevation);
  const double* range = elevation->GetScalarRange();
  const double level = options.Level;
  if (!(range[0] < level && level < range[1]))
  {
    std::ostringstream text;
    text << "level " << level << " m is outside the terrain, which reaches from " << range[0]
         << " to " << range[1] << " m";
    throw std::runtime_error(text.str());
  }
  std::filesystem::create_directories(options.Folder);
  // Before 9.4 VTK needs help to render without an X server.
  if (!vtkWaterOffScreen::EnableIfNeeded())
  {
    throw std::runtime_error(vtkWaterOffScreen::GetReason());
  }

  vtkNew<vtkRenderer> renderer;
  renderer->SetBackground(SKY_AT_BOTTOM[0], SKY_AT_BOTTOM[1], SKY_AT_BOTTOM[2]);
  renderer->SetBackground2(SKY_AT_TOP[0], SKY_AT_TOP[1], SKY_AT_TOP[2]);
  renderer->GradientBackgroundOn();
  renderer->AutomaticLightCreationOff();
  renderer->AddLight(MakeSun());
  const auto terrain = MakeTerrain(Refine(elevation));
  for (vtkActor* actor : terrain)
  {
    renderer->AddActor(actor);
  }

  vtkNew<vtkWaterActor> water;
  water->SetLevel(EXAGGERATION * level);
  renderer->AddActor(water);
  PlaceCamera(renderer, elevation, level);

  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(true);
  window->SetMultiSamples(SAMPLES);
  window->SetSize(SIZE[0], SIZE[1]);
  window->AddRenderer(renderer);

  water->VisibilityOff();
  const double plain_ms = MeasureFrame(window);
  water->VisibilityOn();
  const double water_ms = MeasureFrame(window);
  const std::filesystem::path picture = options.Folder / "lake.png";
  WritePNG(window, picture);

  vtkWaterReflectionPass* reflection = water->GetReflectionPass();
  const int* points = elevation->GetDimensions();
  std::cout << "terrain     " << options.Elevation << ": " << points[0] << " x " << points[1]
            << " points, " << range[0] << " to " << range[1] << " m, drawn " << EXAGGERATION
            << " times higher, in " << terrain.size() << " tiles\n"
            << "water       level " << level << " m\n"
            << "props       " << DescribeFates(reflection) << "\n"
            << "reflection  " << reflection->GetDecisionAsString() << ", "
            << reflection->GetNumberOfReflectionRenders() << " times in " << FRAMES + 1
            << " frames\n"
            << std::fixed << std::setprecision(0) << "frame       " << plain_ms << " ms plain, "
            << water_ms << " ms with water (medians of " << FRAMES << ")\n"
            << "picture     " << picture.string() << " (" << SIZE[0] << " x " << SIZE[1] << ")"
            << std::endl;
  if (*water->GetLastError())
  {
    throw std::runtime_error(water->GetLastError());
  }
}
}

int main(int argc, char* argv[])
{
  try
  {
    Run(ReadOptions(std::vector<std::string>(argv + 1, argv + argc)));
  }
  catch (const UsageError& error)
  {
    std::cerr << USAGE << "\nLake: " << error.what() << std::endl;
    return 2;
  }
  catch (const std::exception& error)
  {
    std::cerr << "Lake: " << error.what() << std::endl;
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
