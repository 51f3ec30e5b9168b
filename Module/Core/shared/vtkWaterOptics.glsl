// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterOptics.glsl: how much the surface reflects; for shaders and, by water_shared.c, for C.
//
// eta is the index of refraction beyond the surface over the one on the eye's side; cosine is that
// of the angle between ray and normal, in [0, 1]; values outside are clamped.

// Reflectance of unpolarised light, exact; 1 under total internal reflection.
// Source: Cook and Torrance 1982, "A Reflectance Model for Computer Graphics".
float waterFresnel(float cosine, float eta)
{
  float c = min(max(cosine, 0.0), 1.0);
  // eta^2 times the squared cosine of the refracted ray (Snell); (eta - 1)(eta + 1) keeps its digits
  // for an eta near 1
  float g2 = (eta - 1.0) * (eta + 1.0) + c * c;
  float g = sqrt(max(g2, 0.0));
  // 0 / 0 is 0: there is no surface at all, eta = 1, along itself
  float s = (c - g) / max(c + g, 1e-30);
  float p = (eta * eta * c - g) / max(eta * eta * c + g, 1e-30);
  return g2 < 0.0 ? 1.0 : 0.5 * (s * s + p * p);
}

// The same by Schlick's approximation. From the denser side the angle is that of the refracted ray,
// which keeps total internal reflection where it is.
// Source: Schlick 1994, "An Inexpensive BRDF Model for Physically-based Rendering".
float waterSchlick(float cosine, float eta)
{
  float c = min(max(cosine, 0.0), 1.0);
  if (eta < 1.0)
  {
    float refracted2 = 1.0 - (1.0 - c * c) / (eta * eta); // Snell
    if (refracted2 < 0.0)
    {
      return 1.0;
    }
    c = sqrt(refracted2);
  }
  float root = (eta - 1.0) / (eta + 1.0);
  float atNormal = root * root;
  float rest = 1.0 - c;
  return atNormal + (1.0 - atNormal) * rest * rest * rest * rest * rest;
}
