#
# Water surfaces that reflect their scene
#

vtk_fetch_module(RenderingWater
  "Water surfaces that reflect their scene"
  GIT_REPOSITORY https://github.com/vtkwater/vtkwater.git
  GIT_TAG v0.2.0
  )
