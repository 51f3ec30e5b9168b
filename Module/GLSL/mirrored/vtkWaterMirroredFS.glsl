// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterMirroredFS.glsl: what a prop's fragments do in the mirrored view. Outside of it the
// uniforms make every function a no-op, so that one program serves both views.

uniform vec4 waterClipWindow;  // water plane in window space, kept side >= 0; (0,0,0,1): keep all
uniform vec4 waterHeadlightVC; // xyz: the user's view direction in view space; w: 1 in the mirror

// Cuts geometry away behind the water.
void waterClip()
{
  if (dot(waterClipWindow, vec4(gl_FragCoord.xyz, 1.0)) < 0.0)
  {
    discard;
  }
}

// A headlight stays at the user's camera: in the mirrored view it shines along waterHeadlightVC
// instead of along the view. This code runs for every pixel of every prop, in both views, so props
// without highlights get the first function only.

// The diffuse factor; outside of the mirror it is normal.z, which is VTK's.
float waterHeadlightDiffuse(vec3 normal)
{
  return max(0.0, -dot(waterHeadlightVC.xyz, normal));
}

// What a surface and a light have in common, in the names of VTK's physically based shading.
void waterHeadlightTerms(vec3 N, vec3 L, vec3 H, out float NdL, out float NdH)
{
  NdL = clamp(dot(N, L), 1e-5, 1.0);
  NdH = clamp(dot(N, H), 1e-5, 1.0);
}

// The same with the light's direction L and the half vector H; outside of the mirror both are the
// direction V to the eye, which VTK takes for them.
void waterHeadlightPhysical(
  vec3 N, vec3 V, out vec3 L, out vec3 H, out float NdL, out float NdH, out float HdL)
{
  L = waterHeadlightVC.w > 0.5 ? -waterHeadlightVC.xyz : V;
  H = normalize(V + L);
  HdL = clamp(dot(H, L), 1e-5, 1.0);
  waterHeadlightTerms(N, L, H, NdL, NdH);
}

// Sets the diffuse factor and returns the base of the specular power, in VTK's terms for a
// directional light; outside of the mirror both are the given factor. No second power is taken:
// software renderers execute both sides of a branch.
float waterHeadlight(vec3 normal, vec3 position, inout float diffuseFactor)
{
  float specularBase = diffuseFactor;
  if (waterHeadlightVC.w > 0.5)
  {
    diffuseFactor = waterHeadlightDiffuse(normal);
    specularBase = diffuseFactor > 0.0
      ? max(0.0, dot(reflect(waterHeadlightVC.xyz, normal), normalize(-position)))
      : 0.0;
  }
  return specularBase;
}
