// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterClarityFS.glsl: slot clarity of water that is the same everywhere.

uniform vec3 waterDeepColor;  // of water without an end
uniform vec3 waterExtinction; // absorption + scattering, per unit of the scene
