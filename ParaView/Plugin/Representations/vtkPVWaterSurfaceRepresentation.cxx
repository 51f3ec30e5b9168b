// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPVWaterSurfaceRepresentation.h"

#include "vtkAlgorithmOutput.h"
#include "vtkAppendPolyData.h"
#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCommunicator.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkDataSetSurfaceFilter.h"
#include "vtkInformation.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkPVRenderView.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkPolyDataNormals.h"
#include "vtkScalarsToColors.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"
#include "vtkWaterActor.h"
#include "vtkWaterProperty.h"
#include "water_placement.h"

#include <algorithm>

namespace
{
// The polygons of a dataset: its own, or its outer surface.
vtkSmartPointer<vtkPolyData> PolygonsOf(vtkDataObject* data)
{
  auto result = vtkSmartPointer<vtkPolyData>::New();
  if (auto* polygons = vtkPolyData::SafeDownCast(data))
  {
    result->ShallowCopy(polygons);
  }
  else if (auto* dataset = vtkDataSet::SafeDownCast(data))
  {
    vtkNew<vtkDataSetSurfaceFilter> surface;
    surface->SetInputData(dataset);
    surface->Update();
    result->ShallowCopy(surface->GetOutput());
  }
  else if (auto* composite = vtkCompositeDataSet::SafeDownCast(data))
  {
    vtkNew<vtkAppendPolyData> all;
    auto block = vtkSmartPointer<vtkCompositeDataIterator>::Take(composite->NewIterator());
    for (block->InitTraversal(); !block->IsDoneWithTraversal(); block->GoToNextItem())
    {
      all->AddInputData(PolygonsOf(block->GetCurrentDataObject()));
    }
    if (all->GetNumberOfInputConnections(0) > 0)
    {
      all->Update();
      result->ShallowCopy(all->GetOutput());
    }
  }
  return result;
}

// Is a bit set in the marks of points or cells? Without marks it is not.
bool IsMarked(vtkUnsignedCharArray* marks, vtkIdType i, unsigned char bit)
{
  return marks && i < marks->GetNumberOfValues() && (marks->GetValue(i) & bit) != 0;
}

// Leaves out the cells that are hidden, or have a hidden point, as vtkWaterSurfaceFilter does: what
// a solver writes there is no height, and belongs neither to the mean level nor to the normals.
void LeaveHidden(vtkPolyData* surface)
{
  vtkUnsignedCharArray* ofPoints = surface->GetPointGhostArray();
  vtkUnsignedCharArray* ofCells = surface->GetCellGhostArray();
  if (!ofPoints && !ofCells)
  {
    return;
  }
  surface->BuildCells();
  bool isAnyHidden = false;
  for (vtkIdType cell = 0; cell < surface->GetNumberOfCells(); ++cell)
  {
    vtkIdType count = 0;
    const vtkIdType* points = nullptr;
    surface->GetCellPoints(cell, count, points);
    if (IsMarked(ofCells, cell, vtkDataSetAttributes::HIDDENCELL) ||
      std::any_of(points, points + count, [ofPoints](vtkIdType point) {
        return IsMarked(ofPoints, point, vtkDataSetAttributes::HIDDENPOINT);
      }))
    {
      surface->DeleteCell(cell);
      isAnyHidden = true;
    }
  }
  if (isAnyHidden)
  {
    surface->RemoveDeletedCells();
  }
}

void AddNormals(vtkPolyData* surface)
{
  double bounds[6]; // without those of hidden cells
  surface->GetCellsBounds(bounds);
  if (surface->GetNumberOfPolys() == 0 || surface->GetPointData()->GetNormals() ||
    bounds[4] == bounds[5])
  {
    return;
  }
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputData(surface);
  normals->SplittingOff();
  normals->ConsistencyOff();
  normals->Update();
  surface->GetPointData()->SetNormals(normals->GetOutput()->GetPointData()->GetNormals());
}

// Mean height of a surface of which this process has a part; ranks: those with the others, or
// nullptr.
double MeanLevelOf(vtkPolyData* surface, vtkMultiProcessController* ranks)
{
  const water_plane ground = { { 0.0, 0.0, 1.0 }, 0.0 };
  water_placement placement;
  water_placement_begin(&ground, &placement);
  auto cell = vtk::TakeSmartPointer(surface->GetPolys()->NewIterator());
  for (cell->GoToFirstCell(); !cell->IsDoneWithTraversal(); cell->GoToNextCell())
  {
    vtkIdType count = 0;
    const vtkIdType* points = nullptr;
    cell->GetCurrentCell(count, points);
    for (vtkIdType i = 2; i < count; ++i)
    {
      double corners[3][3];
      surface->GetPoint(points[0], corners[0]);
      surface->GetPoint(points[i - 1], corners[1]);
      surface->GetPoint(points[i], corners[2]);
      water_placement_add(corners[0], corners[1], corners[2], &placement);
    }
  }
  if (ranks)
  {
    const double own[2] = { placement.area, placement.area_height };
    double all[2] = {};
    ranks->AllReduce(own, all, 2, vtkCommunicator::SUM_OP);
    placement.area = all[0];
    placement.area_height = all[1];
  }
  return water_placement_judge(&placement).height;
}
}

vtkStandardNewMacro(vtkPVWaterSurfaceRepresentation);

//------------------------------------------------------------------------------
vtkPVWaterSurfaceRepresentation::vtkPVWaterSurfaceRepresentation()
{
  vtkNew<vtkPolyData> nothing; // until something is delivered, this is no sheet over the scene
  this->Mapper->SetInputDataObject(nothing);
  this->Mapper->ScalarVisibilityOff();
  this->GetActor()->SetMapper(this->Mapper);
}

//------------------------------------------------------------------------------
vtkPVWaterSurfaceRepresentation::~vtkPVWaterSurfaceRepresentation() = default;

//------------------------------------------------------------------------------
void vtkPVWaterSurfaceRepresentation::SetLookupTable(vtkScalarsToColors* table)
{
  this->Mapper->SetLookupTable(table);
}

//------------------------------------------------------------------------------
void vtkPVWaterSurfaceRepresentation::SetFlowArrayName(const char* name)
{
  const std::string given = name ? name : "";
  this->Set(this->FlowArrayName, given == "None" ? std::string() : given);
}

//------------------------------------------------------------------------------
double vtkPVWaterSurfaceRepresentation::GetMeanLevel()
{
  return this->GetActor()->GetLevel();
}

//------------------------------------------------------------------------------
int vtkPVWaterSurfaceRepresentation::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

//------------------------------------------------------------------------------
void vtkPVWaterSurfaceRepresentation::Keep(vtkDataObject* input, vtkPolyData* piece)
{
  vtkSmartPointer<vtkPolyData> polygons = PolygonsOf(input);
  LeaveHidden(polygons);
  AddNormals(polygons); // with the cells of other ranks, if there are such
  polygons->RemoveGhostCells();
  piece->ShallowCopy(polygons);
}

//------------------------------------------------------------------------------
void vtkPVWaterSurfaceRepresentation::Offer(vtkInformation* inInfo)
{
  vtkPVView::SetPiece(inInfo, this, this->GetPiece());
  double bounds[6];
  this->GetPiece()->GetCellsBounds(bounds); // without points that no cell uses
  vtkPVRenderView::SetGeometryBounds(inInfo, this, bounds);
  // where the servers' pictures are blended in their order, each needs the part in its own space
  vtkPVRenderView::SetOrderedCompositingConfiguration(inInfo, this,
    vtkPVRenderView::DATA_IS_REDISTRIBUTABLE | vtkPVRenderView::USE_DATA_FOR_LOAD_BALANCING);
  this->IsLevelNew[0] = this->IsLevelNew[1] = true;
}

//------------------------------------------------------------------------------
void vtkPVWaterSurfaceRepresentation::OfferCoarse(vtkInformation* inInfo)
{
  vtkPVView::SetPieceLOD(inInfo, this, this->GetPiece());
}

//------------------------------------------------------------------------------
void vtkPVWaterSurfaceRepresentation::Take(vtkInformation* inInfo, vtkMultiProcessController* ranks)
{
  vtkAlgorithmOutput* port = inInfo->Has(vtkPVRenderView::USE_LOD())
    ? vtkPVRenderView::GetPieceProducerLOD(inInfo, this)
    : vtkPVRenderView::GetPieceProducer(inInfo, this);
  vtkAlgorithm* producer = port ? port->GetProducer() : nullptr;
  auto* delivered =
    producer ? vtkPolyData::SafeDownCast(producer->GetOutputDataObject(port->GetIndex())) : nullptr;
  if (delivered && this->Mapper->GetInput() != delivered)
  {
    this->Mapper->SetInputDataObject(delivered);
  }
  const int mode = ranks ? 1 : 0;
  if (this->IsLevelNew[mode]) // the same on all ranks, whatever was delivered to each
  {
    this->IsLevelNew[mode] = false;
    this->Levels[mode] = MeanLevelOf(this->Mapper->GetInput(), ranks);
  }
  if (this->GetActor()->GetLevel() != this->Levels[mode])
  {
    this->GetActor()->SetLevel(this->Levels[mode]);
  }
  this->ApplyColors();
}

//------------------------------------------------------------------------------
void vtkPVWaterSurfaceRepresentation::ApplyColors()
{
  vtkInformation* array = this->GetInputArrayInformation(0);
  const char* name =
    array->Has(vtkDataObject::FIELD_NAME()) ? array->Get(vtkDataObject::FIELD_NAME()) : nullptr;
  if (!name || !name[0] || !this->Mapper->GetLookupTable())
  {
    this->Mapper->ScalarVisibilityOff();
    return;
  }
  const bool isOfCells =
    array->Get(vtkDataObject::FIELD_ASSOCIATION()) == vtkDataObject::FIELD_ASSOCIATION_CELLS;
  this->Mapper->SetScalarMode(
    isOfCells ? VTK_SCALAR_MODE_USE_CELL_FIELD_DATA : VTK_SCALAR_MODE_USE_POINT_FIELD_DATA);
  this->Mapper->SelectColorArray(name);
  this->Mapper->SetColorModeToMapScalars();
  this->Mapper->UseLookupTableScalarRangeOn();
  this->Mapper->SetInterpolateScalarsBeforeMapping(!isOfCells);
  this->Mapper->ScalarVisibilityOn();
}

//------------------------------------------------------------------------------
void vtkPVWaterSurfaceRepresentation::ApplyMore(vtkWaterProperty* look)
{
  look->SetDataOpacity(this->DataOpacity);
  this->GetActor()->SetFlowArrayName(this->FlowArrayName);
  this->GetActor()->SetFlowPeriod(this->FlowPeriod);
  this->GetActor()->SetMeshSlopes(this->MeshSlopes);
}

//------------------------------------------------------------------------------
void vtkPVWaterSurfaceRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "DataOpacity: " << this->DataOpacity << "\n";
  os << indent << "FlowArrayName: " << this->FlowArrayName << "\n";
  os << indent << "FlowPeriod: " << this->FlowPeriod << "\n";
  os << indent << "MeshSlopes: " << this->MeshSlopes << "\n";
}
