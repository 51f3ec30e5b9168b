// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterMatterFS.glsl: slot clarity of water that carries matter (water_matter.h): how much, its vertices know
// (vtkWaterMatterVS.glsl). A ray sees what is where it goes into the water, all along its way.

in float waterMatterVSOutput;        // concentration
uniform vec3 waterClearDeepColor;    // of the water without it, and without an end
uniform vec3 waterClearExtinction;   // absorption + scattering, per unit of the scene
uniform vec3 waterClearScattering;   // per unit of the scene
uniform vec3 waterMatterExtinction;  // the same of the matter, per unit of concentration
uniform vec3 waterMatterScattering;
uniform vec3 waterDaylight;          // of a white card in the plane, linear
uniform int waterMatterIsDeep;       // 1: it colors water without an end; 0: that has a color of its own

vec3 waterDeepColor = vec3(0.0); // as of vtkWaterClarityFS.glsl, at the pixel
vec3 waterExtinction = vec3(0.0);

vec3 waterMixture(vec3 clear, vec3 perUnit, float concentration)
{
  return vec3(waterWithMatter(clear.r, perUnit.r, concentration), waterWithMatter(clear.g, perUnit.g, concentration),
    waterWithMatter(clear.b, perUnit.b, concentration));
}

vec3 waterDeepMixture(vec3 scattering)
{
  return vec3(waterEncoded(waterDaylight.r * waterSentBack(scattering.r, waterExtinction.r)),
    waterEncoded(waterDaylight.g * waterSentBack(scattering.g, waterExtinction.g)),
    waterEncoded(waterDaylight.b * waterSentBack(scattering.b, waterExtinction.b)));
}

// Before anything is seen in the water. Where there is no matter all is as without it, to the bit.
//
// isAbove  the eye is: below the surface it looks through water whose matter is not known
void waterTakeMatter(bool isAbove)
{
  float concentration = isAbove ? max(waterMatterVSOutput, 0.0) : 0.0;
  waterExtinction = waterMixture(waterClearExtinction, waterMatterExtinction, concentration);
  bool isColored = waterMatterIsDeep != 0 && concentration > 0.0;
  waterDeepColor = isColored ? waterDeepMixture(waterMixture(waterClearScattering, waterMatterScattering, concentration))
                             : waterClearDeepColor;
}
