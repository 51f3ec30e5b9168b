// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPVWaterRepresentation.h"

#include "vtkAlgorithmOutput.h"
#include "vtkBoundingBox.h"
#include "vtkCallbackCommand.h"
#include "vtkCamera.h"
#include "vtkCommand.h"
#include "vtkDataObject.h"
#include "vtkInformation.h"
#include "vtkInformationRequestKey.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkOrderedCompositingHelper.h"
#include "vtkPVRenderView.h"
#include "vtkPVRenderViewDataDeliveryManager.h"
#include "vtkPVSession.h"
#include "vtkPVWaterSheetSource.h"
#include "vtkPolyData.h"
#include "vtkProcessModule.h"
#include "vtkRenderer.h"
#include "vtkWaterActor.h"
#include "vtkWaterC.h"
#include "vtkWaterProperty.h"
#include "vtkWaterReflectionPass.h"

#include <algorithm>
#include <cstring>
#include <limits>

namespace
{
// Is the module that is loaded the one that the plugin was built with? Members and virtual
// functions of another may lie elsewhere.
bool IsModuleOfPlugin()
{
  return std::strcmp(vtk_water_version(), WATER_PLUGIN_VERSION) == 0;
}
}

vtkStandardNewMacro(vtkPVWaterRepresentation);

//------------------------------------------------------------------------------
vtkPVWaterRepresentation::vtkPVWaterRepresentation()
  : Session(vtkPVSession::SafeDownCast(vtkProcessModule::GetProcessModule()->GetActiveSession()))
{
  this->Starts->SetClientData(this);
  this->Starts->SetCallback([](vtkObject* renderer, unsigned long, void* self, void*) {
    static_cast<vtkPVWaterRepresentation*>(self)->FindFarthest(vtkRenderer::SafeDownCast(renderer));
  });
}

//------------------------------------------------------------------------------
vtkPVWaterRepresentation::~vtkPVWaterRepresentation()
{
  this->Starts->SetClientData(nullptr);
  this->Starts->SetCallback(nullptr);
}

//------------------------------------------------------------------------------
void vtkPVWaterRepresentation::ChangeLook()
{
  this->IsLookNew = true;
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkPVWaterRepresentation::AddSineWave(double amplitude, double wavelength, double direction)
{
  this->Settings.Sines.insert(this->Settings.Sines.end(), { amplitude, wavelength, direction });
  this->ChangeLook();
}

//------------------------------------------------------------------------------
void vtkPVWaterRepresentation::RemoveAllSineWaves()
{
  this->Settings.Sines.clear();
  this->ChangeLook();
}

//------------------------------------------------------------------------------
void vtkPVWaterRepresentation::SetDeepColor(double red, double green, double blue)
{
  const double color[3] = { red, green, blue };
  std::copy_n(color, 3, this->Settings.DeepColor);
  this->ChangeLook();
}

//------------------------------------------------------------------------------
void vtkPVWaterRepresentation::SetFoamColor(double red, double green, double blue)
{
  const double color[3] = { red, green, blue };
  std::copy_n(color, 3, this->Settings.FoamColor);
  this->ChangeLook();
}

//------------------------------------------------------------------------------
int vtkPVWaterRepresentation::GetNumberOfReflectionRenders()
{
  return static_cast<int>(this->Actor->GetReflectionPass()->GetNumberOfReflectionRenders());
}

//------------------------------------------------------------------------------
int vtkPVWaterRepresentation::GetNumberOfPixelsJoined()
{
  return static_cast<int>(this->Actor->GetReflectionPass()->GetNumberOfPixelsJoined());
}

//------------------------------------------------------------------------------
const char* vtkPVWaterRepresentation::GetDecision()
{
  return this->Actor->GetReflectionPass()->GetDecisionAsString();
}

//------------------------------------------------------------------------------
const char* vtkPVWaterRepresentation::GetLastError()
{
  return this->Actor->GetLastError();
}

//------------------------------------------------------------------------------
double vtkPVWaterRepresentation::GetWaveTime()
{
  return this->Actor->GetTime();
}

//------------------------------------------------------------------------------
void vtkPVWaterRepresentation::SetVisibility(bool isVisible)
{
  this->Superclass::SetVisibility(isVisible);
  this->Actor->SetVisibility(isVisible);
}

//------------------------------------------------------------------------------
int vtkPVWaterRepresentation::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

//------------------------------------------------------------------------------
int vtkPVWaterRepresentation::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkDataObject* input = inputVector[0]->GetNumberOfInformationObjects() > 0
    ? vtkDataObject::GetData(inputVector[0])
    : nullptr;
  this->Keep(input, this->Piece);
  return this->Superclass::RequestData(request, inputVector, outputVector);
}

//------------------------------------------------------------------------------
void vtkPVWaterRepresentation::Keep(vtkDataObject* input, vtkPolyData* piece)
{
  input ? piece->ShallowCopy(input) : piece->Initialize();
}

//------------------------------------------------------------------------------
bool vtkPVWaterRepresentation::AddToView(vtkView* view)
{
  auto* renderView = vtkPVRenderView::SafeDownCast(view);
  if (!renderView)
  {
    return false;
  }
  if (!IsModuleOfPlugin())
  {
    vtkErrorMacro("The library vtkRenderingWater that is loaded has version "
      << vtk_water_version() << ", but the plugin was built with version " << WATER_PLUGIN_VERSION
      << ". The water is not shown. Install the plugin and the library of one package, and remove "
      << "the folder of the other from LD_LIBRARY_PATH.");
    return false;
  }
  renderView->GetRenderer()->AddActor(this->Actor);
  // after what brings the ranks' cameras together
  renderView->GetRenderer()->AddObserver(vtkCommand::StartEvent, this->Starts, -0.5f);
  return this->Superclass::AddToView(view);
}

//------------------------------------------------------------------------------
bool vtkPVWaterRepresentation::RemoveFromView(vtkView* view)
{
  if (auto* renderView = vtkPVRenderView::SafeDownCast(view))
  {
    renderView->GetRenderer()->RemoveActor(this->Actor);
    renderView->GetRenderer()->RemoveObserver(this->Starts);
  }
  return this->Superclass::RemoveFromView(view);
}

//------------------------------------------------------------------------------
int vtkPVWaterRepresentation::ProcessViewRequest(
  vtkInformationRequestKey* request, vtkInformation* inInfo, vtkInformation* outInfo)
{
  if (!this->Superclass::ProcessViewRequest(request, inInfo, outInfo))
  {
    return 0;
  }
  auto* view = vtkPVRenderView::SafeDownCast(inInfo->Get(vtkPVView::VIEW()));
  if (request == vtkPVView::REQUEST_UPDATE())
  {
    this->Offer(inInfo);
    // ranks exchange their mirrored views while they draw: IceT must not pass over one that shows
    // nothing
    outInfo->Set(vtkPVRenderView::RENDER_EMPTY_IMAGES(), 1);
  }
  else if (request == vtkPVView::REQUEST_UPDATE_LOD())
  {
    this->OfferCoarse(inInfo);
  }
  else if (request == vtkPVView::REQUEST_RENDER() && view)
  {
    this->PrepareRender(view, inInfo);
  }
  return 1;
}

//------------------------------------------------------------------------------
void vtkPVWaterRepresentation::Offer(vtkInformation* inInfo)
{
  vtkPVView::SetPiece(inInfo, this, this->Piece);
  // every server has the same few numbers, and the client needs them to render by itself
  vtkPVRenderView::SetDeliverToClientAndRenderingProcesses(inInfo, this, true, false);
  if (vtkPVWaterSheetSource::Place(this->Piece, this->Actor) && this->Actor->GetUseSheetBounds())
  {
    vtkPVRenderView::SetGeometryBounds(inInfo, this, this->Actor->GetBounds());
  }
}

//------------------------------------------------------------------------------
void vtkPVWaterRepresentation::Take(vtkInformation* inInfo, vtkMultiProcessController*)
{
  vtkAlgorithmOutput* port = vtkPVRenderView::GetPieceProducer(inInfo, this);
  vtkAlgorithm* producer = port ? port->GetProducer() : nullptr;
  if (producer)
  {
    vtkPVWaterSheetSource::Place(
      vtkPolyData::SafeDownCast(producer->GetOutputDataObject(port->GetIndex())), this->Actor);
  }
}

//------------------------------------------------------------------------------
void vtkPVWaterRepresentation::PrepareRender(vtkPVRenderView* view, vtkInformation* inInfo)
{
  if (this->IsLookNew)
  {
    this->IsLookNew = false;
    this->ApplyLook();
  }
  this->Actor->SetTime(this->Settings.TimeScale * view->GetViewTime() + this->Settings.TimeShift);
  const bool isDistributed = view->GetUseDistributedRenderingForRender();
  const bool isServer =
    !this->Session || this->Session->HasProcessRole(vtkPVSession::RENDER_SERVER);
  // a client that gets the servers' picture has nothing to reflect
  this->Actor->SetVisibility(this->GetVisibility() && (isServer || !isDistributed));
  // whether ranks compose one picture changes from frame to frame: no other frame may exchange
  vtkMultiProcessController* ranks =
    isDistributed && isServer ? vtkMultiProcessController::GetGlobalController() : nullptr;
  if (isServer || !isDistributed)
  {
    this->Take(inInfo, ranks);
  }
  // translucent data and volumes: the servers' pictures are blended in their order
  auto* delivery = vtkPVRenderViewDataDeliveryManager::SafeDownCast(view->GetDeliveryManager());
  this->AreServersInOrder =
    ranks && delivery && view->GetUseOrderedCompositing() && this->IsWhole();
  if (this->AreServersInOrder)
  {
    this->ServersInOrder->SetBoundingBoxes(delivery->GetCuts());
  }
  this->FindRegion(ranks ? ranks->GetLocalProcessId() : -1);
  vtkWaterReflectionPass* pass = this->Actor->GetReflectionPass();
  pass->SetController(ranks);
  // IceT's pass blanks it while it draws
  pass->KeepBackground(ranks ? view->GetRenderer() : nullptr);
  // the view's passes are unknown to the water, which would keep half floats for them
  pass->SetColorPrecision(view->GetUseToneMapping() ? vtkWaterReflectionPass::HALF_FLOAT
                                                    : vtkWaterReflectionPass::EIGHT_BIT);
}

namespace
{
// A rank's part of the space. The outer ones have no end: the water may be wider than the data.
// false: the part has no width.
bool RegionOf(const vtkBoundingBox& box, const vtkBoundingBox& all, double region[6])
{
  if (!box.IsValid())
  {
    return false;
  }
  const double endless = std::numeric_limits<double>::infinity();
  double outer[6];
  box.GetBounds(region);
  all.GetBounds(outer);
  bool isWide = true;
  for (int i = 0; i < 3; ++i)
  {
    double* sides = region + 2 * i;
    const double* ends = outer + 2 * i;
    isWide = isWide && (sides[0] < sides[1] || ends[0] == ends[1]);
    sides[0] = sides[0] == ends[0] ? -endless : sides[0];
    sides[1] = sides[1] == ends[1] ? endless : sides[1];
  }
  return isWide;
}
}

//------------------------------------------------------------------------------
void vtkPVWaterRepresentation::FindRegion(int rank)
{
  const std::vector<vtkBoundingBox>& boxes = this->ServersInOrder->GetBoundingBoxes();
  vtkWaterReflectionPass* pass = this->Actor->GetReflectionPass();
  vtkBoundingBox all;
  for (const vtkBoundingBox& box : boxes)
  {
    all.AddBox(box);
  }
  // all ranks have a region, or none: each of them looks at the boxes of all
  const bool areRegions =
    std::all_of(boxes.begin(), boxes.end(), [&all](const vtkBoundingBox& box) {
      double region[6];
      return RegionOf(box, all, region);
    });
  double region[6];
  if (this->AreServersInOrder && rank >= 0 && static_cast<size_t>(rank) < boxes.size() &&
    areRegions && RegionOf(boxes[static_cast<size_t>(rank)], all, region))
  {
    pass->SetRankRegion(region);
    return;
  }
  pass->ResetRankRegion();
}

//------------------------------------------------------------------------------
void vtkPVWaterRepresentation::FindFarthest(vtkRenderer* renderer)
{
  std::vector<int> order;
  if (this->AreServersInOrder)
  {
    order = this->ServersInOrder->ComputeSortOrder(renderer->GetActiveCamera());
  }
  this->Actor->GetReflectionPass()->SetFarthestRank(order.empty() ? -1 : order.back());
}

//------------------------------------------------------------------------------
void vtkPVWaterRepresentation::ApplyWaves(vtkWaterProperty* look)
{
  const Look& settings = this->Settings;
  if (settings.WaveMode != WAVES_OF_PRESET)
  {
    look->SetSea(settings.WaveMode == WIND_SEA);
    look->RemoveAllWaves();
  }
  if (settings.WaveMode == WIND_SEA)
  {
    look->SetWindSpeed(settings.WindSpeed);
    look->SetWindDirection(settings.WindDirection);
    look->SetFetch(settings.Fetch);
    look->SetSeed(settings.SeaSeed);
  }
  if (settings.WaveMode == SINES)
  {
    for (size_t i = 0; i + 2 < settings.Sines.size(); i += 3)
    {
      look->AddWave(settings.Sines[i], settings.Sines[i + 1], settings.Sines[i + 2]);
    }
  }
  look->SetWhitecaps(settings.Whitecaps);
  look->SetWaveGeometry(settings.WaveGeometry);
}

//------------------------------------------------------------------------------
void vtkPVWaterRepresentation::ApplyOptics(vtkWaterProperty* look)
{
  const Look& settings = this->Settings;
  if (settings.Refraction != OF_PRESET)
  {
    look->SetRefraction(settings.Refraction == ON);
  }
  if (settings.WaterType != "none")
  {
    look->SetWaterType(settings.WaterType.c_str());
  }
  if (settings.UseDeepColor)
  {
    look->SetDeepColor(settings.DeepColor);
  }
  look->SetOpacity(settings.Opacity);
  look->SetCaustics(settings.Caustics);
  look->SetLightShafts(settings.LightShafts);
  look->SetDomePortRadius(settings.DomePortRadius);
  look->SetShoreSoftness(settings.ShoreSoftness);
  look->SetFoamDepth(settings.FoamDepth);
  look->SetFoamStretch(settings.FoamStretch);
  look->SetFoamColor(settings.FoamColor);
  look->SetGlitter(settings.Glitter);
  look->SetShadows(settings.Shadows);
}

//------------------------------------------------------------------------------
void vtkPVWaterRepresentation::ApplyLook()
{
  const Look& settings = this->Settings;
  vtkNew<vtkWaterProperty> look;
  if (settings.Preset != "none")
  {
    look->SetPreset(settings.Preset.c_str());
  }
  this->ApplyWaves(look);
  this->ApplyOptics(look);
  look->SetMetresPerUnit(settings.MetresPerUnit);
  look->SetRayTraceQuality(settings.Quality.c_str());
  this->ApplyMore(look);
  this->Actor->SetWaterProperty(look);
  this->Actor->SetSceneReflection(settings.SceneReflection);
  this->Actor->GetReflectionPass()->SetTextureScale(settings.TextureScale);
}

//------------------------------------------------------------------------------
void vtkPVWaterRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Preset: " << this->Settings.Preset << "\n";
  os << indent << "Actor:\n";
  this->Actor->PrintSelf(os, indent.GetNextIndent());
}
