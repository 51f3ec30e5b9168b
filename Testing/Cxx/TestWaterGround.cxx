// SPDX-License-Identifier: BSD-3-Clause
// What a process knows of its ground holds whatever came before: a rank whose join was not ended,
// or was ended by an exception, reads its ground anew once it goes on alone. So it does with other
// ranks.
#include "WaterBasin.h"
#include "WaterTestScene.h"

#include "vtkWaterGround.h"

#include "vtkPolyDataMapper.h"

#include <stdexcept>
#include <vector>

namespace
{
const double kBounds[6] = { -9.0, 9.0, -9.0, 9.0, -0.8, 1.8 };

// A prop that throws when it is asked what it shows.
class ThrowingActor : public vtkActor
{
public:
  static ThrowingActor* New();
  vtkTypeMacro(ThrowingActor, vtkActor);
  bool IsBroken = false;
  void InitPathTraversal() override
  {
    if (this->IsBroken)
    {
      throw std::runtime_error("nothing to be seen");
    }
    this->vtkActor::InitPathTraversal();
  }
};
vtkStandardNewMacro(ThrowingActor);

// A basin whose rim is over the water.
vtkSmartPointer<ThrowingActor> MakeBasin()
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(WaterMakeBasin(-9.0, -9.0, 18.0, 72));
  auto basin = vtkSmartPointer<ThrowingActor>::New();
  basin->SetMapper(mapper);
  return basin;
}

using Scene = std::vector<vtkRenderer*>;

std::vector<double> WetOf(vtkWaterGround& ground, const water_plane& plane, const Scene& scene)
{
  return ground.IsUnder(plane, kBounds, scene) ? ground.GetWet() : std::vector<double>();
}

bool Throws(vtkWaterGround& ground, const water_plane& plane, const Scene& scene, bool isPart)
{
  try
  {
    isPart ? ground.ReadPart(plane, kBounds, scene, 1).size() : WetOf(ground, plane, scene).size();
  }
  catch (const std::runtime_error&)
  {
    return true;
  }
  return false;
}
}

int TestWaterGround(int, char*[])
{
  vtkNew<vtkRenderer> renderer;
  const vtkSmartPointer<ThrowingActor> basin = MakeBasin();
  renderer->AddActor(basin);
  const Scene scene = { renderer };
  water_plane plane = water_plane();
  plane.normal[2] = 1.0;
  vtkWaterGround fresh;
  const std::vector<double> wet = WetOf(fresh, plane, scene);
  bool ok = WaterCheck("a part of the basin is dry", !wet.empty(), true);

  vtkWaterGround left; // the other ranks are lost before it is joined
  left.ReadPart(plane, kBounds, scene, 1);
  ok &= WaterCheck("after a join that was not ended", WetOf(left, plane, scene) == wet, true);

  vtkWaterGround joined;
  joined.JoinBelow(joined.Join(plane, kBounds, joined.ReadPart(plane, kBounds, scene, 1)));
  ok &= WaterCheck("it is joined", joined.IsJoined(plane, kBounds, scene, 1), true);
  ok &= WaterCheck("it is not of other ranks", joined.IsJoined(plane, kBounds, scene, 2), false);
  ok &= WaterCheck("joined of one", joined.IsUnderOfRanks(plane), true);
  ok &= WaterCheck("the same is dry", joined.GetWet() == wet, true);

  for (bool isPart : { true, false })
  {
    vtkWaterGround broken;
    basin->IsBroken = true;
    ok &= WaterCheck("the read throws", Throws(broken, plane, scene, isPart), true);
    basin->IsBroken = false;
    ok &= WaterCheck("after a read that threw", WetOf(broken, plane, scene) == wet, true);
  }
  return ok ? EXIT_SUCCESS : EXIT_FAILURE;
}
