// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWaterShaderText.h"

#include "vtkShaderProgram.h"

//------------------------------------------------------------------------------
void vtkWaterShaderText::InsertBefore(
  std::string& source, const std::string& tag, const std::string& text)
{
  vtkShaderProgram::Substitute(source, tag, text + "\n" + tag, false);
}

//------------------------------------------------------------------------------
void vtkWaterShaderText::InsertAfter(
  std::string& source, const std::string& tag, const std::string& text)
{
  vtkShaderProgram::Substitute(source, tag, tag + "\n" + text, false);
}

//------------------------------------------------------------------------------
bool vtkWaterShaderText::InsertDeclarations(std::string& source, const std::string& text)
{
  const std::string tag = "//VTK::Clip::Dec";
  const std::string place = source.find(tag) != std::string::npos ? tag : "void main(";
  return vtkShaderProgram::Substitute(source, place, text + "\n" + place, false);
}

//------------------------------------------------------------------------------
bool vtkWaterShaderText::Declares(const std::string& source, const std::string& function)
{
  return source.find(function + "(") != std::string::npos;
}

//------------------------------------------------------------------------------
void vtkWaterShaderText::MoveHeadlight(std::string& source)
{
  const std::string isotropic = "SpecularIsotropic(NdV, NdV, NdV, 1.0,";
  const std::string anisotropic =
    "SpecularAnisotropic(at, ab, V, tangentVC, bitangentVC, V, TdV, BdV, NdV, NdV, NdV,\n1.0,";
  if (source.find(isotropic) == std::string::npos && source.find(anisotropic) == std::string::npos)
  {
    return; // unlit, or of other lights
  }
  InsertAfter(source, "float NdL, NdH, HdL, distanceVC, attenuation, D, Vis;",
    "  waterHeadlightPhysical(N, V, L, H, NdL, NdH, HdL);");
  InsertAfter(
    source, "float coatNdL, coatNdH;", "  waterHeadlightTerms(coatN, L, H, coatNdL, coatNdH);");
  const char* const terms[][2] = {
    { isotropic.c_str(), "SpecularIsotropic(NdH, NdV, NdL, HdL," },
    { anisotropic.c_str(),
      "SpecularAnisotropic(at, ab, L, tangentVC, bitangentVC, H, TdV, BdV, NdH, NdV, NdL, HdL," },
    { "SpecularIsotropic(coatNdV, coatNdV, coatNdV, 1.0,",
      "SpecularIsotropic(coatNdH, coatNdV, coatNdL, HdL," },
    { "radiance * coatNdV * coatStrength", "radiance * coatNdL * coatStrength" },
    { "(diffuse + specular) * NdV", "(diffuse + specular) * NdL" },
  };
  for (const auto& term : terms)
  {
    vtkShaderProgram::Substitute(source, term[0], term[1], false);
  }
}

//------------------------------------------------------------------------------
void vtkWaterShaderText::MoveHeadlightOfVolumes(std::string& source)
{
  vtkShaderProgram::Substitute(
    source, "phase_function(-1)", "phase_function(waterHeadlightTurn(tex_light))", false);
  const bool areSeveral = source.find("g_ldir[1] =") != std::string::npos;
  for (int i = 0;; ++i)
  {
    const std::string index = "[" + std::to_string(i) + "]";
    const std::string matrix = "[" + std::to_string(areSeveral ? i + 1 : i) + "]";
    const std::string line = "g_ldir" + index + " =";
    if (source.find(line) == std::string::npos)
    {
      return;
    }
    InsertBefore(source, line,
      "g_lightPosObj" + index + " = waterHeadlightPlace(g_lightPosObj" + index +
        ", in_inverseVolumeMatrix" + matrix + ");");
  }
}
