// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPVWaterSurfaceFilter.h"

#include "vtkDataSet.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkWaterSurfaceFilter.h"

namespace
{
std::string NameOf(const char* name)
{
  const std::string given = name ? name : "";
  return given == "None" ? std::string() : given;
}
}

vtkStandardNewMacro(vtkPVWaterSurfaceFilter);

//------------------------------------------------------------------------------
vtkPVWaterSurfaceFilter::vtkPVWaterSurfaceFilter() = default;

//------------------------------------------------------------------------------
vtkPVWaterSurfaceFilter::~vtkPVWaterSurfaceFilter() = default;

//------------------------------------------------------------------------------
void vtkPVWaterSurfaceFilter::Changed(vtkMTimeType before)
{
  if (this->Filter->GetMTime() != before)
  {
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkPVWaterSurfaceFilter::SetLevelArrayName(const char* name)
{
  const vtkMTimeType before = this->Filter->GetMTime();
  this->Filter->SetLevelArrayName(NameOf(name));
  this->Changed(before);
}

//------------------------------------------------------------------------------
void vtkPVWaterSurfaceFilter::SetDepthArrayName(const char* name)
{
  const vtkMTimeType before = this->Filter->GetMTime();
  this->Filter->SetDepthArrayName(NameOf(name));
  this->Changed(before);
}

//------------------------------------------------------------------------------
void vtkPVWaterSurfaceFilter::SetBedArrayName(const char* name)
{
  const vtkMTimeType before = this->Filter->GetMTime();
  this->Filter->SetBedArrayName(NameOf(name));
  this->Changed(before);
}

//------------------------------------------------------------------------------
void vtkPVWaterSurfaceFilter::SetDryDepth(double depth)
{
  const vtkMTimeType before = this->Filter->GetMTime();
  this->Filter->SetDryDepth(depth);
  this->Changed(before);
}

//------------------------------------------------------------------------------
void vtkPVWaterSurfaceFilter::SetVerticalScale(double scale)
{
  const vtkMTimeType before = this->Filter->GetMTime();
  this->Filter->SetVerticalScale(scale);
  this->Changed(before);
}

//------------------------------------------------------------------------------
int vtkPVWaterSurfaceFilter::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet");
  return 1;
}

//------------------------------------------------------------------------------
int vtkPVWaterSurfaceFilter::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  vtkInformation* input = inputVector[0]->GetInformationObject(0);
  vtkInformation* output = outputVector->GetInformationObject(0);
  if (output->Get(Pipeline::UPDATE_NUMBER_OF_PIECES()) > 1)
  {
    const int wanted = output->Get(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS());
    input->Set(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), wanted + 1);
  }
  return 1;
}

//------------------------------------------------------------------------------
int vtkPVWaterSurfaceFilter::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  // a copy: with the input itself, the filter would ask this filter's own pipeline for an update
  vtkDataSet* input = vtkDataSet::GetData(inputVector[0]);
  auto copy = vtkSmartPointer<vtkDataSet>::Take(input->NewInstance());
  copy->ShallowCopy(input);
  this->Filter->SetInputDataObject(copy);
  this->Filter->Update();
  vtkPolyData::GetData(outputVector)->ShallowCopy(this->Filter->GetOutput());
  this->Filter->SetInputDataObject(nullptr);
  return 1;
}

//------------------------------------------------------------------------------
void vtkPVWaterSurfaceFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Filter:\n";
  this->Filter->PrintSelf(os, indent.GetNextIndent());
}
