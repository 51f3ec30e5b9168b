// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWaterErrors.h"

#include "vtkCamera.h"
#include "vtkProp.h"
#include "vtkWaterGather.h"

#include <sstream>

namespace
{
void DescribePlane(std::ostream& text, const vtkWaterSnapshot& water)
{
  const double* origin = water.GivenOrigin;
  const double* normal = water.GivenNormal;
  text << "; its origin is (" << origin[0] << ", " << origin[1] << ", " << origin[2]
       << "), its normal (" << normal[0] << ", " << normal[1] << ", " << normal[2] << ")";
}

void DescribeCamera(std::ostream& text, vtkCamera* camera)
{
  const double* position = camera->GetPosition();
  const double* focus = camera->GetFocalPoint();
  const double* range = camera->GetClippingRange();
  text << "; it is at (" << position[0] << ", " << position[1] << ", " << position[2]
       << "), looks at (" << focus[0] << ", " << focus[1] << ", " << focus[2] << "), view angle "
       << camera->GetViewAngle() << ", clipping range (" << range[0] << ", " << range[1] << ")";
}

void DescribeValue(
  std::ostream& text, water_status status, const vtkWaterGather& gather, const water_plan& plan)
{
  const water_scene& scene = gather.Scene;
  switch (status)
  {
    case WATER_BAD_VIEWPORT:
      text << "; it is " << scene.viewport_px[0] << " x " << scene.viewport_px[1];
      break;
    case WATER_BAD_TEXTURE_SCALE:
      text << "; it is " << scene.settings.texture_scale;
      break;
    case WATER_TEXTURE_TOO_LARGE:
      text << ": a picture of " << scene.viewport_px[0] << " x " << scene.viewport_px[1]
           << " pixels times TextureScale " << scene.settings.texture_scale << " exceeds "
           << scene.max_texture_px << " pixels";
      break;
    case WATER_BAD_CLIP_MARGIN:
      text << "; it is " << scene.settings.clip_margin;
      break;
    case WATER_BAD_INDEX:
      text << "; it is " << scene.look.index_of_refraction;
      break;
    case WATER_BAD_REFLECTANCE:
      text << "; it is " << scene.look.reflectance;
      break;
    case WATER_BAD_CAMERA:
    case WATER_CAMERA_ON_PLANE:
      DescribeCamera(text, gather.Camera);
      break;
    case WATER_BAD_PROP_BOUNDS:
    {
      const double* bounds = scene.props[plan.bad_index].bounds;
      text << "; those of prop " << plan.bad_index << " ("
           << gather.DrawnProps[plan.bad_index]->GetClassName() << ") are (" << bounds[0] << ", "
           << bounds[1] << ", " << bounds[2] << ", " << bounds[3] << ", " << bounds[4] << ", "
           << bounds[5] << ")";
      break;
    }
    default:
      break;
  }
}
}

//------------------------------------------------------------------------------
vtkWaterError vtkWaterDescribe(water_status status, const vtkWaterSnapshot& water,
  const vtkWaterGather* gather, const water_plan* plan)
{
  std::ostringstream text;
  text << water_status_text(status);
  vtkWaterError error;
  error.Kind = text.str();
  if (status == WATER_BAD_PROP_BOUNDS && plan)
  {
    error.Kind += std::to_string(plan->bad_index);
  }
  if (status == WATER_BAD_PLANE)
  {
    DescribePlane(text, water);
  }
  else if (gather && plan)
  {
    DescribeValue(text, status, *gather, *plan);
  }
  text << (status == WATER_BAD_PROP_BOUNDS ? ". It is reflected as if it were everywhere."
                                           : ". The water shows its plain colour.");
  error.Text = text.str();
  return error;
}

//------------------------------------------------------------------------------
vtkWaterError vtkWaterDescribeEmptySkybox()
{
  vtkWaterError error;
  error.Kind = "a visible vtkSkybox has no data in its texture";
  error.Text = error.Kind +
    ": SetTexture needs one whose input has at least one pixel or, for the projection Cube, a cube "
    "map of six such inputs. The water reflects the renderer's background instead.";
  return error;
}
