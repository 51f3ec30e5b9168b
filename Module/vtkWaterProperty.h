// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkWaterProperty
 * @brief   the look of a water surface
 *
 * The colour of a water pixel is the reflection, weighted by the reflectance, plus what is visible
 * through the surface: the colour of deep water or, with Refraction, the scene below. Each setter
 * states its accepted range. It rejects other values with an error that names the value and the
 * range, and keeps the last valid value.
 *
 * @sa vtkWaterActor
 */
#ifndef vtkWaterProperty_h
#define vtkWaterProperty_h

#include "vtkObject.h"
#include "vtkRenderingWaterModule.h" // for the export macro
#include "vtkWrappingHints.h"        // for VTK_WRAPEXCLUDE

#include <memory> // for std::unique_ptr
#include <vector> // for waves

struct vtkWaterLook;
struct water_medium;
struct water_preset;
struct water_sea;
struct water_cascades;
struct water_wave;

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif

class vtkTexture;

class VTKRENDERINGWATER_EXPORT vtkWaterProperty : public vtkObject
{
public:
  static vtkWaterProperty* New();
  vtkTypeMacro(vtkWaterProperty, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum ReflectanceModes
  {
    FRESNEL = 0,
    CONSTANT = 1
  };

  ///@{
  /**
   * Source of the reflectance. FRESNEL: computed exactly for unpolarised light from
   * IndexOfRefraction and the viewing angle, with total internal reflection from under water.
   * CONSTANT: the value of Reflectance. Default is FRESNEL.
   *
   * Source of the formula: Born & Wolf, "Principles of Optics", section 1.5.2.
   */
  void SetReflectanceMode(int mode);
  vtkGetMacro(ReflectanceMode, int);
  void SetReflectanceModeToFresnel() { this->SetReflectanceMode(FRESNEL); }
  void SetReflectanceModeToConstant() { this->SetReflectanceMode(CONSTANT); }
  const char* GetReflectanceModeAsString() const;
  ///@}

  ///@{
  /**
   * Share of the reflection in a pixel if ReflectanceMode is CONSTANT, in [0, 1]. 1 is a perfect
   * mirror: the pixel shows only the reflection. At 0 no reflection is rendered. Default is 1.
   */
  void SetReflectance(double reflectance);
  vtkGetMacro(Reflectance, double);
  ///@}

  ///@{
  /**
   * Refractive index of the water relative to the medium above it (IndexOfRefraction), in [1, 10].
   * Default is 1.333.
   */
  void SetIndexOfRefraction(double index);
  vtkGetMacro(IndexOfRefraction, double);
  ///@}

  ///@{
  /**
   * Whether the scene is visible through the surface. It is refracted by Snell's law and attenuated
   * by Absorption and Scattering along its path through the water; with a longer path it fades into
   * DeepColor. RefractionSource says where the refracted colours come from. No effect if Opacity is
   * below 1. Default is off: the water shows only DeepColor.
   */
  void SetRefraction(bool refraction);
  vtkGetMacro(Refraction, bool);
  vtkBooleanMacro(Refraction, bool);
  ///@}

  enum RefractionSources
  {
    PICTURE = 0,
    OWN_VIEW = 1,
    AUTOMATIC = 2
  };

  ///@{
  /**
   * Where the refracted colours come from (RefractionSources). PICTURE: the main picture; no extra
   * view of the scene is rendered. What lies outside the picture or behind objects above the water
   * is guessed from what is near it, and translucent props and volumes are not visible through the
   * water. OWN_VIEW: an additional view of the scene beyond the surface, twice as wide and high as
   * the picture and without anything on the near side of the water's plane. It is rendered when
   * the camera or the scene has changed, not when only the waves have. It shows cube axes and polar
   * axes, but no other labels. If the GPU has no memory for it, PICTURE is used. AUTOMATIC:
   * OWN_VIEW if the water reaches to the horizon (vtkWaterActor::SheetToHorizon, or
   * SheetToAutomatic in open water), and the camera is above the surface and looks down by less
   * than 30 degrees; otherwise PICTURE. Needs Refraction. Default is PICTURE.
   */
  void SetRefractionSource(int source);
  vtkGetMacro(RefractionSource, int);
  void SetRefractionSourceToPicture() { this->SetRefractionSource(PICTURE); }
  void SetRefractionSourceToOwnView() { this->SetRefractionSource(OWN_VIEW); }
  void SetRefractionSourceToAutomatic() { this->SetRefractionSource(AUTOMATIC); }
  const char* GetRefractionSourceAsString() const;
  ///@}

  ///@{
  /**
   * Absorption of the water, 1/m at 650, 550 and 450 nm (red, green, blue): in [0, 1e9].
   * Lengths in the scene's unit are converted by MetresPerUnit. After a path of x metres, the
   * fraction exp(-(absorption + scattering) x) of the light remains. Default is that of a clear
   * lake (water_preset_default).
   */
  void SetAbsorption(double red, double green, double blue);
  void SetAbsorption(const double perMetre[3])
  {
    this->SetAbsorption(perMetre[0], perMetre[1], perMetre[2]);
  }
  vtkGetVector3Macro(Absorption, double);
  ///@}

  ///@{
  /**
   * Scattering of the water, 1/m at 650, 550 and 450 nm (red, green, blue): in [0, 1e9].
   * Count only scattering out of the line of sight; for real water this is the backward part.
   * Default is that of a clear lake (water_preset_default).
   */
  void SetScattering(double red, double green, double blue);
  void SetScattering(const double perMetre[3])
  {
    this->SetScattering(perMetre[0], perMetre[1], perMetre[2]);
  }
  vtkGetVector3Macro(Scattering, double);
  ///@}

  ///@{
  /**
   * Sets Absorption and Scattering to those of one of Jerlov's optical water types, and
   * DeepColorMode to MEDIUM. The types are "I", "IA", "IB", "II", "III" (ocean), "1C", "3C", "5C",
   * "7C", "9C" (coast, clear to turbid).
   *
   * Returns false, with an error, for another name. GetWaterType returns the type that matches the
   * current Absorption and Scattering, however they were set, or nullptr if none matches.
   *
   * Source: Jerlov 1976, "Marine Optics", table XXVII.
   */
  bool SetWaterType(const char* name);
  const char* GetWaterType() const;
  ///@}

  ///@{
  /**
   * Sets the optics and the waves to a preset: "pool", "lake", "clear tropical", "ocean wind 5",
   * "ocean wind 10", "ocean wind 15" (m/s), "turbid river" or "mirror floor". GetPresetSource
   * returns the source of its numbers (nullptr for another name). Lookup and its settings, Output,
   * Opacity, Seed, SeaTileSize and SeaPeriod do not change.
   *
   * Returns false, with an error, for another name; nothing changes then. GetPreset returns the
   * preset whose values are all set now, or nullptr if there is none.
   */
  bool SetPreset(const char* name);
  const char* GetPreset() const;
  ///@}
  static int GetNumberOfPresets();
  static const char* GetPresetName(int number); // nullptr if there is no preset of this number
  static const char* GetPresetSource(const char* name);

  enum DeepColorModes
  {
    MEDIUM = 0,
    GIVEN = 1
  };

  ///@{
  /**
   * Source of the colour of infinitely deep water. MEDIUM: the share of the light that the water
   * scatters back up, 0.33 b / (a + b) with the absorption a and the scattering b, under the
   * renderer's distant lights and background. Positional lights are ignored; a headlight is treated
   * as a light at the eye. GIVEN:
   * DeepColor, independent of the light. Default is MEDIUM.
   *
   * Source: Morel and Prieur 1977, "Analysis of Variations in Ocean Color".
   */
  void SetDeepColorMode(int mode);
  vtkGetMacro(DeepColorMode, int);
  void SetDeepColorModeToMedium() { this->SetDeepColorMode(MEDIUM); }
  void SetDeepColorModeToGiven() { this->SetDeepColorMode(GIVEN); }
  const char* GetDeepColorModeAsString() const;
  ///@}

  ///@{
  /**
   * Colour of infinitely deep water: it is visible where the water does not reflect and, with
   * Refraction, where the water is deep. Red, green, blue, each in [0, 1]. Setting it sets
   * DeepColorMode to GIVEN. In the mode MEDIUM, the default, GetDeepColor returns the colour under
   * white daylight; if the actor's vtkProperty has a colour, that colour is drawn instead. For an
   * eye under water, the haze is derived from it, and depends on depth, direction and the sun; a
   * colour that was set is the haze everywhere.
   */
  void SetDeepColor(double red, double green, double blue);
  void SetDeepColor(const double rgb[3]) { this->SetDeepColor(rgb[0], rgb[1], rgb[2]); }
  vtkGetVector3Macro(DeepColor, double);
  ///@}

  ///@{
  /**
   * Metres per unit of the scene, in [1e-9, 1e9]. All lengths of this class are in metres and are
   * converted to the scene's unit. 0 means automatic: a scene that is 256 to 1024 units across is
   * treated as a scene in metres, a smaller one as 200 to 400 m across, a larger one as 1000 to
   * 2000 m across. A preset may have other ranges (a pool: 4 to 32 units are metres, a smaller
   * scene is 4 to 8 m across, a larger one 20 to 40 m). With automatic units, waves shorter than
   * 1/400 of the scene are not shown, and GetWaveHeight agrees with what is shown. Without a
   * preset, light is attenuated as if the deepest bed were 30 m deep, or 120 m in a wide scene, ten
   * times as wide as deep, whose heights often differ in scale from its widths. A flat bed, such
   * as the floor of a pool or a tank, is treated as 5 m deep if the water's automatic sheet ends
   * with its ground. If the automatic sheet reaches to the horizon, the deepest part of the objects
   * in the water is treated as 10 m deep. Default is 1.
   */
  void SetMetresPerUnit(double metres);
  vtkGetMacro(MetresPerUnit, double);
  void SetMetresPerUnitToAutomatic() { this->SetMetresPerUnit(0.0); }
  ///@}

  /**
   * Sets MetresPerUnit by the name of the scene's unit: one of "um", "mm", "cm", "m", "km", "in",
   * "ft", "mi" and "automatic". Default is "m".
   *
   * Returns false, with an error, for another name.
   */
  bool SetUnits(const char* name);

  ///@{
  /**
   * Vertical exaggeration of the scene: the factor by which its heights are drawn higher than they
   * are, in [1e-6, 1e6]. Depths are divided by it before light is attenuated, and before the foam
   * and the softness of the shore are placed, so that drawn water looks as clear as the real one.
   * Refraction and reflection follow what is drawn. With automatic units it has no effect, because
   * they fit the depth of the scene. Default is 1.
   */
  void SetVerticalExaggeration(double factor);
  vtkGetMacro(VerticalExaggeration, double);
  ///@}

  ///@{
  /**
   * Depth over which the reflection fades in at a shore, m: finite and not negative. Only with
   * Refraction, which provides the depth. Default is 0.05, or a tenth of the depth to which the
   * scene reaches below the water if that is less. A value that is set is used as it is.
   */
  void SetShoreSoftness(double depth);
  vtkGetMacro(ShoreSoftness, double);
  ///@}

  ///@{
  /**
   * Radius of a dome port, m: the glass dome, centred on the eye, of an underwater camera's
   * housing. Finite and not negative; 0, the default, means no port. If the camera is less than
   * this radius above the water, the picture is half above and half under water: view rays that
   * meet the surface within the radius start under water and are neither refracted nor reflected by
   * it. A port needs Refraction and a camera with perspective above the surface. If the water does
   * not reach to the horizon, the near plane must be closer to the eye than the surface.
   */
  void SetDomePortRadius(double radius);
  vtkGetMacro(DomePortRadius, double);
  ///@}

  enum ReflectionSources
  {
    SCENE = 0,
    ENVIRONMENT = 1
  };

  ///@{
  /**
   * Source of the reflection. SCENE: the scene, rendered by a mirrored camera. ENVIRONMENT: a
   * static picture, without an extra view: EnvironmentTexture or, without one, the sky that VTK
   * shows (a skybox or the renderer's background). Default is SCENE.
   */
  void SetReflectionSource(int source);
  vtkGetMacro(ReflectionSource, int);
  void SetReflectionSourceToScene() { this->SetReflectionSource(SCENE); }
  void SetReflectionSourceToEnvironment() { this->SetReflectionSource(ENVIRONMENT); }
  const char* GetReflectionSourceAsString() const;
  ///@}

  ///@{
  /**
   * Picture of the surroundings in longitude and latitude, like that of a vtkSkybox with the
   * projection Sphere. The renderer's EnvironmentUp and EnvironmentRight orient it. It is also the
   * sky for rays that leave the mirrored view, for an eye under water, and for this water in
   * another water's reflection. Without a texture, these use the sky that VTK shows: a skybox or
   * the renderer's background. A cube map is rejected with an error. Default is nullptr.
   */
  void SetEnvironmentTexture(vtkTexture* texture);
  vtkTexture* GetEnvironmentTexture() const;
  ///@}

  ///@{
  /**
   * Glitter of the sun on waves, and on water with a SlopeVariance, computed from the distribution
   * of the slopes. Waves hide each other from a low sun and at a low angle of view. The sun is the
   * brightest scene light of the renderer; a headlight does not count. Default is on.
   *
   * Sources: Cox and Munk 1954, "Measurement of the Roughness of the Sea Surface from Photographs
   * of the Sun's Glitter"; Smith 1967, "Geometrical Shadowing of a Random Rough Surface".
   */
  void SetGlitter(bool glitter);
  vtkGetMacro(Glitter, bool);
  vtkBooleanMacro(Glitter, bool);
  ///@}

  ///@{
  /**
   * Whether glitter brighter than white rolls off towards white (HighlightRollOff), so that it
   * keeps its shape and the sun's colour. Glitter that takes up at most 0.72 of the range left
   * below white does not change. The roll-off is always off if a pass of the renderer may
   * apply tone mapping. Default is on.
   */
  void SetHighlightRollOff(bool rolls);
  vtkGetMacro(HighlightRollOff, bool);
  vtkBooleanMacro(HighlightRollOff, bool);
  ///@}

  ///@{
  /**
   * Variance of the slopes of waves that are too small to be added one by one: along a direction
   * (degrees) and across it, both in [0, 1e6]. SetSlopeVarianceToWind sets the values that Cox and
   * Munk measured for a wind speed in [0.1, 100] m/s; its direction is the one in which the wind
   * blows. Default is 0.
   */
  void SetSlopeVariance(double along, double across, double direction = 0.0);
  void SetSlopeVarianceToWind(double speed, double direction = 0.0);
  void GetSlopeVariance(double variance[3]) const; // along, across, direction
  ///@}

  ///@{
  /**
   * Foam where the water is shallower than FoamDepth, m: finite and not negative. Needs Refraction.
   * The foam covers the waterline, and bands of it travel towards the shore with a period of 12 s.
   * Default is 0: no foam.
   */
  void SetFoamDepth(double depth);
  vtkGetMacro(FoamDepth, double);
  ///@}

  ///@{
  /**
   * Whether the depth of the foam fits the scene: with automatic units, FoamDepth is increased to
   * at least 1/400 of the scene's diagonal, so that the foam is visible in a picture of the whole
   * scene. Has no effect with other units or without FoamDepth. Default is off.
   */
  vtkSetMacro(FoamFitsScene, bool);
  vtkGetMacro(FoamFitsScene, bool);
  vtkBooleanMacro(FoamFitsScene, bool);
  ///@}

  ///@{
  /**
   * Foam on the crests of steep waves: where points of the surface are closer than FoamStretch
   * times their distance at rest, in [0, 1]. Default is 0: no foam.
   */
  void SetFoamStretch(double stretch);
  vtkGetMacro(FoamStretch, double);
  ///@}

  ///@{
  /**
   * Colour of the foam: red, green, blue, each in [0, 1]. The sun lights it. Default is (0.95,
   * 0.97, 1).
   */
  void SetFoamColor(double red, double green, double blue);
  void SetFoamColor(const double rgb[3]) { this->SetFoamColor(rgb[0], rgb[1], rgb[2]); }
  vtkGetVector3Macro(FoamColor, double);
  ///@}

  ///@{
  /**
   * Shadows of objects on the water's glitter and foam. Objects that cast a shadow into the picture
   * are drawn along the sun's rays into a separate view, even if they are outside the picture
   * themselves. The view has as many pixels as the picture. It is drawn again when the camera, the
   * sun or an object has changed; with several ranks (SetController), when one of these has changed
   * on any rank. Translucent props, volumes and props that are not reflected cast no shadows. The
   * sun is treated as infinitely distant. Default is off.
   * Source: Blinn 1988, "Me and My (Fake) Shadow".
   */
  void SetShadows(bool shadows);
  vtkGetMacro(Shadows, bool);
  vtkBooleanMacro(Shadows, bool);
  ///@}

  ///@{
  /**
   * Strength of caustics, the light that waves focus on the bed, in [0, 1]. Needs Refraction, waves
   * and a sun (a scene light). At 1 the light is physical: it is traced from the slopes of the
   * waves to the bed and conserved, and is blurred only by the sun's disc, the pixels of the
   * picture and the smallest waves. Displaced waves light the bed as if they lay in the plane. If a
   * GPU has no float textures, an ErrorEvent is reported once, and the bed is lit as under calm
   * water. Default is 0: no caustics. Source: Shah et al. 2007, "Caustics Mapping".
   */
  void SetCaustics(double strength);
  vtkGetMacro(Caustics, double);
  ///@}

  ///@{
  /**
   * Light shafts for a camera under water: the share, in [0, 1], of the light in the water and on
   * objects in it that the waves above focus into shafts. The mean light stays that of calm water.
   * Needs Refraction, waves, a sun, a medium (absorption or scattering in every channel) and a
   * camera with perspective. Default is 0: no shafts. Source: Iwasaki et al. 2002, "An
   * Efficient Method for Rendering Underwater Optical Effects Using Graphics Hardware".
   */
  void SetLightShafts(double share);
  vtkGetMacro(LightShafts, double);
  ///@}

  ///@{
  /**
   * Opacity of data colours, in [0, 1], if the actor's mapper shows scalars through its lookup
   * table. At 1 these colours replace the colour of the water and hide what lies below; below 1
   * they are blended with it. The opacity of each colour in the table multiplies this value, so
   * that a table can show clear water where a dye is thin. Reflection, glitter and foam are added
   * on top. Without them (SetReflectance(0), GlitterOff), the picture shows exactly the colours of
   * the lookup table, unlit. Default is 1.
   */
  void SetDataOpacity(double opacity);
  vtkGetMacro(DataOpacity, double);
  ///@}

  ///@{
  /**
   * Opacity of the surface for alpha blending with what lies behind it, in [0, 1]. Below 1 the
   * water is drawn with the translucent geometry. Default is 1.
   */
  void SetOpacity(double opacity);
  vtkGetMacro(Opacity, double);
  ///@}

  ///@{
  /**
   * Adds a wave; there may be any number. The height of the surface is the sum over all waves of
   * amplitude * sin(k . x + phase - omega t), with x in the plane's own axes and omega from the
   * dispersion relation for Depth. The surface is a flat sheet with the normals of the waves, or
   * displaced (WaveGeometry).
   *
   * amplitude  m, half the height from trough to crest, in [0, 1e9]
   * wavelength m, finite and greater than 0
   * direction  degrees in which the wave travels, from the plane's first axis towards the second
   * phase      degrees, at the axes' origin and time 0
   * steepness  [0, 1]: 0 is a sine, 1 a Gerstner wave with cusps; the sum of 2 pi amplitude
   *            steepness / wavelength over all waves must not exceed 1, or the surface would fold
   *
   * Returns the wave's number, or -1 if it was rejected (with an error that names the value).
   * GetWave returns the five numbers, or false if there is no such wave.
   *
   * Sources: Airy 1845, "Tides and Waves"; Fournier and Reeves 1986, "A Simple Model of Ocean
   * Waves".
   */
  int AddWave(double amplitude, double wavelength, double direction = 0.0, double phase = 0.0,
    double steepness = 0.0);
  void RemoveAllWaves();
  int GetNumberOfWaves() const;
  bool GetWave(int number, double wave[5]) const;
  ///@}

  ///@{
  /**
   * SetWave changes the five values of a wave (those of AddWave). RemoveWave removes it; the index
   * of each later wave then decreases by one. The wave's number must lie in [0, GetNumberOfWaves()
   * - 1]. Returns false, with an error, if it does not or if the new numbers are rejected; no wave
   * changes then.
   */
  bool SetWave(int number, double amplitude, double wavelength, double direction = 0.0,
    double phase = 0.0, double steepness = 0.0);
  bool RemoveWave(int number);
  ///@}

  /**
   * Root mean square slope of all waves, including the waves of the sea that its tiles hold.
   */
  double GetSlopeRMS() const;

  /**
   * Upper bound of the waves' height above or below the plane, m: the sum of their amplitudes plus,
   * if WaveGeometry displaces a wind sea, 6 standard deviations of its height. One in 6e7 crests of
   * the sea is higher.
   */
  double GetWaveHeightMax() const;

  ///@{
  /**
   * Adds one of at most two normal maps that move over the water, in addition to other waves. In a
   * texture, red and green are the components of the normal along the plane's axes, and blue is the
   * component upwards; -1 to 1 are stored as 0 to 255. The texture has 3 or 4 channels of 8 bits,
   * and 2 x 2 to 4096 x 4096 pixels. nullptr selects a built-in map of ripples with an rms slope of
   * 0.1. Normal maps have no heights: GetWaveHeight and GetWaveNormal ignore them.
   *
   * size       m of water that the map covers, in [1e-6, 1e9]
   * speed      m/s at which it moves, finite
   * direction  degrees in which it moves, from the plane's first axis towards the second
   * strength   factor of its slopes, in [-1000, 1000]
   *
   * AddNormalMap returns the map's number, or -1 if it was rejected (with an error that names the
   * value). GetNormalMap returns the four numbers, or false if there is no such map.
   */
  int AddNormalMap(vtkTexture* texture, double size, double speed = 0.0, double direction = 0.0,
    double strength = 1.0);
  void RemoveAllNormalMaps();
  int GetNumberOfNormalMaps() const;
  bool GetNormalMap(int number, double map[4]) const;
  vtkTexture* GetNormalMapTexture(int number) const; // also the built-in one; nullptr: no such map
  ///@}

  ///@{
  /**
   * Whether the waves of AddWave and the wind sea displace the surface (WaveGeometry). Normal maps
   * do not. The displacement is vertical and, for steep waves and the sea (SeaChoppiness), also
   * horizontal. Off: a flat sheet with the waves' normals, which is cheaper, and accurate if waves
   * are low compared with the objects in them. On: the built-in sheet becomes a grid over the
   * visible area. A user's mesh is displaced at its points and not refined, so it needs several
   * points per wavelength. No effect without waves, nor on edges and wide lines. Default is off.
   */
  void SetWaveGeometry(bool geometry);
  vtkGetMacro(WaveGeometry, bool);
  vtkBooleanMacro(WaveGeometry, bool);
  ///@}

  ///@{
  /**
   * Number of cells of the grid for displaced waves (WaveGeometry), both across the view and into
   * its depth, in [16, 2048]. Where a wave spans fewer than four cells, it loses part of its
   * height; with fewer than two, only its normals remain. Default is 256.
   */
  void SetWaveGridSize(int size);
  vtkGetMacro(WaveGridSize, int);
  ///@}

  ///@{
  /**
   * Depth of the water for the waves' speed and the sea's spectrum, m: greater than 0; infinity is
   * deep water. Default is infinity.
   */
  void SetDepth(double depth);
  vtkGetMacro(Depth, double);
  ///@}

  ///@{
  /**
   * A wind sea: random waves with the spectrum that a wind raises, on square tiles that repeat in
   * both directions (SeaCascades). They are added to the waves of AddWave. Between the points of a
   * tile, heights and slopes are interpolated bilinearly, both in GetWaveHeight and in the picture.
   * Waves too short for a pixel or for the tiles roughen the reflection. Default is off.
   *
   * Source: Tessendorf 2001, "Simulating Ocean Water".
   */
  void SetSea(bool sea);
  vtkGetMacro(Sea, bool);
  vtkBooleanMacro(Sea, bool);
  ///@}

  ///@{
  /**
   * Wind speed at a height of 10 m, m/s in [0.1, 100]. Default is 5.
   */
  void SetWindSpeed(double speed);
  vtkGetMacro(WindSpeed, double);
  ///@}

  ///@{
  /**
   * Direction in which the wind blows, in degrees from the plane's first axis towards the second:
   * finite. Default is 0.
   */
  void SetWindDirection(double direction);
  vtkGetMacro(WindDirection, double);
  ///@}

  ///@{
  /**
   * Fetch: the length of open water upwind, m: at least 1; infinity is a fully developed sea.
   * Default is 10000.
   */
  void SetFetch(double fetch);
  vtkGetMacro(Fetch, double);
  ///@}

  enum SeaModels
  {
    JONSWAP = 0,
    PHILLIPS = 1
  };

  ///@{
  /**
   * Spectrum of the sea. JONSWAP: a growing sea, with the TMA factor for finite Depth. PHILLIPS: a
   * fully developed sea in deep water, with as many waves against the wind as with it; Fetch and
   * PeakEnhancement have no effect. Default is JONSWAP.
   *
   * Sources: Hasselmann et al. 1973, "Measurements of Wind-Wave Growth and Swell Decay during the
   * Joint North Sea Wave Project"; Bouws et al. 1985, "Similarity of the Wind Wave Spectrum in
   * Finite Depth Water 1" (TMA); Donelan, Hamilton and Hui 1985, "Directional Spectra of
   * Wind-Generated Waves" (directions); Tessendorf 2001 for the Phillips spectrum.
   */
  void SetSeaModel(int model);
  vtkGetMacro(SeaModel, int);
  void SetSeaModelToJONSWAP() { this->SetSeaModel(JONSWAP); }
  void SetSeaModelToPhillips() { this->SetSeaModel(PHILLIPS); }
  const char* GetSeaModelAsString() const;
  ///@}

  ///@{
  /**
   * Peak enhancement factor of the JONSWAP spectrum: the height of its peak relative to that of a
   * fully developed sea, in [1, 20]. Default is 3.3, the mean of the measurements.
   */
  void SetPeakEnhancement(double enhancement);
  vtkGetMacro(PeakEnhancement, double);
  ///@}

  ///@{
  /**
   * Seed of the sea's random numbers, any integer: the same seed gives the same sea. Default is 1.
   */
  void SetSeed(int seed);
  vtkGetMacro(Seed, int);
  ///@}

  ///@{
  /**
   * Points along a side of each tile of the sea: a power of two in [32, 1024]. The shortest waves
   * are two points long. The time to compute a sea is proportional to the square of this number.
   * Default is 256.
   */
  void SetSeaTileSize(int size);
  vtkGetMacro(SeaTileSize, int);
  ///@}

  ///@{
  /**
   * Side length of the first tile, m: in [0.001, 1e9], or 0 for 24 times the wavelength of the
   * spectral peak (10 times with one tile), which preserves the sea's height within 1 %. Shorter
   * tiles repeat sooner and lack the waves longer than the tile; with one tile they show shorter
   * waves near the eye. GetUsedSeaTileLength returns the length in use. Default is 0.
   */
  void SetSeaTileLength(double length);
  vtkGetMacro(SeaTileLength, double);
  double GetUsedSeaTileLength() const;
  ///@}

  ///@{
  /**
   * Time after which the sea repeats exactly, s: finite, not negative; 0 means never. The frequency
   * of every wave is rounded to a multiple of 1/SeaPeriod. Default is 0.
   */
  void SetSeaPeriod(double period);
  vtkGetMacro(SeaPeriod, double);
  ///@}

  ///@{
  /**
   * Number of tiles of the sea (its cascades), in [1, 3], each with a band of the waves. The first
   * has the longest waves; each further tile is shorter by the same factor (at most 19 for 256
   * points). With three tiles, the sea includes waves of a few centimetres. The sea repeats after
   * the length of its first tile: by default 24 wavelengths of the peak with several tiles, 10 with
   * one. If fewer tiles already reach waves of 1.7 cm, fewer are used: GetUsedSeaCascades returns
   * their number. The time to compute a sea is proportional to the number of tiles. A pixel larger
   * than the waves of a tile does not read that tile. Three tiles show ripples close to the eye.
   * Default is 2.
   *
   * Source: Bruneton, Neyret and Holzschuch 2010, "Real-time Realistic Ocean Lighting using
   * Seamless Transitions from Geometry to BRDF".
   */
  void SetSeaCascades(int cascades);
  vtkGetMacro(SeaCascades, int);
  int GetUsedSeaCascades() const;
  ///@}

  ///@{
  /**
   * Share of the horizontal displacement of a displaced sea (WaveGeometry), in [0, 1]: 1 is that of
   * Gerstner waves, with sharp crests and flat troughs; 0 is vertical displacement only. Default is
   * 1.
   *
   * Source: Tessendorf 2001, "Simulating Ocean Water" (choppy waves).
   */
  void SetSeaChoppiness(double choppiness);
  vtkGetMacro(SeaChoppiness, double);
  ///@}

  ///@{
  /**
   * Whether a wind sea has foam where its crests break (Whitecaps). The foam appears where the
   * sea's points are closest together, and covers the share of the surface that was measured for
   * the wind speed (GetWhitecapCover; 0 if whitecaps or the sea are off). It has FoamColor and does
   * not need a displaced surface. Default is off.
   *
   * Sources: Monahan and O'Muircheartaigh 1980, "Optimal Power-Law Description of Oceanic Whitecap
   * Coverage Dependence on Wind Speed" (the share); Tessendorf 2001 (the place).
   */
  void SetWhitecaps(bool whitecaps);
  vtkGetMacro(Whitecaps, bool);
  vtkBooleanMacro(Whitecaps, bool);
  double GetWhitecapCover() const;
  ///@}

  ///@{
  /**
   * Lifetime of whitecaps, seconds in [0, 10]: foam stays where a crest of the sea broke, and
   * after this time a share 1/e of it is left. Breaking crests and this older foam together cover
   * GetWhitecapCover of the surface on average. Only crests of the sea's first tile (SeaCascades)
   * leave foam behind. The foam depends only on the time (vtkWaterActor::SetTime), not on earlier
   * frames. 0: whitecaps appear and vanish with their crest. Default is 3.5.
   *
   * Source: Callaghan, Deane, Stokes and Ward 2012, "Observed Variation in the Decay Time of
   * Oceanic Whitecap Foam" (0.5 to 8 s, longer for larger breakers).
   */
  void SetWhitecapLifeTime(double seconds);
  vtkGetMacro(WhitecapLifeTime, double);
  ///@}

  enum Lookups
  {
    RAY_TRACED = 0,
    FIXED_OFFSET = 1,
    VIEW_SCALED_OFFSET = 2,
    MOVED_POINT = 3
  };

  ///@{
  /**
   * Method to look up the reflection of waves in the mirrored view. RAY_TRACED: follows the
   * reflected ray until it meets a surface in the mirrored view. FIXED_OFFSET: the calm reflection,
   * shifted by the normal times OffsetScale (in fractions of the picture). VIEW_SCALED_OFFSET: the
   * same, divided by the distance from the eye. MOVED_POINT: the calm reflection of a point moved
   * by the normal times OffsetScale (in the scene's unit). The last three are fast but inaccurate;
   * most programs use them, and they are provided for comparison. Default is RAY_TRACED.
   */
  void SetLookup(int lookup);
  vtkGetMacro(Lookup, int);
  void SetLookupToRayTraced() { this->SetLookup(RAY_TRACED); }
  void SetLookupToFixedOffset() { this->SetLookup(FIXED_OFFSET); }
  void SetLookupToViewScaledOffset() { this->SetLookup(VIEW_SCALED_OFFSET); }
  void SetLookupToMovedPoint() { this->SetLookup(MOVED_POINT); }
  const char* GetLookupAsString() const;
  ///@}

  ///@{
  /**
   * Scale factor of the three offset lookups (OffsetScale), in [-1000, 1000]. Default is 0.3.
   */
  void SetOffsetScale(double scale);
  vtkGetMacro(OffsetScale, double);
  ///@}

  ///@{
  /**
   * Steps of the ray-traced lookup: the number of steps for rays that do not converge at once, in
   * [1, 256]. Default is 16.
   */
  void SetRayTraceSteps(int steps);
  vtkGetMacro(RayTraceSteps, int);
  ///@}

  ///@{
  /**
   * Probes of the ray-traced lookup: the number of samples between the water and the point where
   * the ray converged, in [0, 64]. Default is 6. Pixels that do not resolve their waves also send a
   * nearly level ray, which has up to 12 samples of its own.
   */
  void SetRayTraceProbes(int probes);
  vtkGetMacro(RayTraceProbes, int);
  ///@}

  ///@{
  /**
   * Rays of the ray-traced lookup: the number of rays for a pixel whose neighbour has another
   * colour, in [1, 16]. All other pixels have one. Pixels of rough water also have one: if this
   * number is at most 4, they show the mean of up to three facets, and if it is larger, the
   * integral over all slopes, which is smooth and takes longer. Unless RayTraceLayers is 2, GPUs
   * use one ray in every pixel, because several cost a quarter of the frame there. Default is 4.
   */
  void SetRayTraceRays(int rays);
  vtkGetMacro(RayTraceRays, int);
  ///@}

  ///@{
  /**
   * Layers of the ray-traced lookup: the number of layers of the mirrored view that rays see, in
   * [1, 2]. With 2, a ray that passes behind an object's edge continues among the geometry behind
   * it. This geometry is rendered into a second layer, whenever the mirrored view is rendered.
   * Default is 1.
   */
  void SetRayTraceLayers(int layers);
  vtkGetMacro(RayTraceLayers, int);
  ///@}

  ///@{
  /**
   * Size of the square, in pixels, over which the waves' slopes are averaged, in [0, 1]. 1: the
   * whole pixel. 0: the slopes at the pixel's centre; a single frame then flickers if waves are
   * smaller than a pixel, and the mean of many frames (vtkWaterFrameAverage) shows all of them. At
   * 0 the reflection texture has twice the resolution. Default is 1.
   */
  void SetRayTraceFootprint(double footprint);
  vtkGetMacro(RayTraceFootprint, double);
  ///@}

  ///@{
  /**
   * Sets steps, probes, rays, layers and footprint together, by a name, which must be one of these:
   *
   *               steps  probes  rays  layers  footprint
   *     fast          8       3     1       1          1
   *     default      16       6     4       1          1
   *     high         24      12     8       2          1
   *     reference   256      64     1       2          0
   *
   * "high" also multisamples the reflection of calm water
   * (vtkWaterReflectionPass::SetMultiSamples). "reference" is meant for vtkWaterFrameAverage, which
   * supplies one ray per frame.
   */
  void SetRayTraceQuality(const char* name);
  void SetRayTraceQualityToFast() { this->SetRayTraceQuality("fast"); }
  void SetRayTraceQualityToDefault() { this->SetRayTraceQuality("default"); }
  void SetRayTraceQualityToHigh() { this->SetRayTraceQuality("high"); }
  void SetRayTraceQualityToReference() { this->SetRayTraceQuality("reference"); }
  ///@}

  enum Outputs
  {
    COLOR = 0,
    CONFIDENCE = 1,
    LOOKUP = 2,
    REFLECTANCE = 3
  };

  /**
   * Reasons for the colour of a pixel, as shown by the output CONFIDENCE: all three channels are
   * this number of 255.
   */
  enum Confidences
  {
    NOT_REFLECTING = 0, // there is no mirrored view
    HIT = 1,            // the ray meets a surface
    SKY = 2,            // the ray leaves the scene within the mirrored view
    OFF_MAP = 3,        // the ray leaves the mirrored view: sky, or the colour at its border
    HIDDEN = 4,         // the ray passes behind an object in the mirrored view
    DOWNWARD = 5        // the ray would meet the water again; it was reflected once more
  };

  ///@{
  /**
   * Quantity that the water shows. COLOR: its colour. CONFIDENCE: how its reflection was found
   * (Confidences). LOOKUP: the coordinates in the reflection texture at which the pixel's colour
   * was read, u and v in [0, 1] as 12 bits each: red and the high half of green are u, the rest v.
   * REFLECTANCE: in [0, 1] as 16 bits: red is the high byte and green the low one. CONFIDENCE and
   * LOOKUP use the mean slope of the pixel and ignore its roughness. Default is COLOR.
   */
  void SetOutput(int output);
  vtkGetMacro(Output, int);
  void SetOutputToColor() { this->SetOutput(COLOR); }
  void SetOutputToConfidence() { this->SetOutput(CONFIDENCE); }
  void SetOutputToLookup() { this->SetOutput(LOOKUP); }
  void SetOutputToReflectance() { this->SetOutput(REFLECTANCE); }
  const char* GetOutputAsString() const;
  ///@}

  /**
   * Copies all settings of another water's look; textures are shared. nullptr changes nothing.
   */
  void DeepCopy(vtkWaterProperty* other);

  vtkMTimeType GetMTime() override; // of its textures, too

  ///@{
  /**
   * Internal access of the module to the look: all of it at once, the waves of AddWave, and the sea
   * with its tile, whether it is on or not. Not for use.
   */
  // diagonal  of the scene, units; for automatic units
  VTK_WRAPEXCLUDE void Describe(double diagonal, vtkWaterLook& look);
  VTK_WRAPEXCLUDE const water_wave* GetWaves() const;
  VTK_WRAPEXCLUDE int ReadSea(water_sea* sea, water_cascades* cascades) const;
  ///@}

protected:
  vtkWaterProperty();
  ~vtkWaterProperty() override;

private:
  vtkWaterProperty(const vtkWaterProperty&) = delete;
  void operator=(const vtkWaterProperty&) = delete;

  void DescribeWaves(vtkWaterLook& look);
  void DescribeUnits(double diagonal, vtkWaterLook& look) const;
  // Variances xx, yy, xy of all slopes, at all times; normal maps are not counted.
  void GetMeanSlopes(bool hidesWaves, double covariance[3]) const;
  void DescribeSea(vtkWaterLook& look);
  void UpdateSeaSlopes() const;
  void GetSeaSlopes(double held[2], double leftOut[2]) const;
  // Does this water have all values of a preset?
  bool IsPreset(const water_preset& preset) const;
  // Is there a wave of this number? If not, reports the accepted range.
  bool HasWave(const char* what, int number);
  // Replaces the waves if the new ones are valid; otherwise reports what is wrong.
  bool UseWaves(std::vector<water_wave>& waves, int number, const char* otherwise);
  // Rejects a colour with a channel outside [0, 1].
  // Returns whether the colour is valid.
  bool SetColor(const char* name, double (&member)[3], double red, double green, double blue);
  void UpdateDeepColor();
  void PrintSea(ostream& os, vtkIndent indent) const;
  // Sets one of the sea's numbers if the core accepts it.
  template <typename T>
  void SetOfSea(const char* name, T& member, T value);
  // Sets one of the two if the core accepts the resulting medium.
  void SetMedium(const char* name, double (vtkWaterProperty::*member)[3], const double value[3]);
  void UseMedium(const water_medium& medium);

  struct Internals;
  std::unique_ptr<Internals> Internal;
  int ReflectanceMode = FRESNEL;
  double Reflectance = 1.0;
  double IndexOfRefraction = 1.333;
  bool Refraction = false;
  int RefractionSource = PICTURE;
  double Absorption[3] = { 0.0, 0.0, 0.0 };
  double Scattering[3] = { 0.0, 0.0, 0.0 };
  int DeepColorMode = MEDIUM;
  double DeepColor[3] = {};
  double MetresPerUnit = 1.0;
  double VerticalExaggeration = 1.0;
  double ShoreSoftness = 0.05;
  bool HasShoreSoftness = false; // it is set
  double DomePortRadius = 0.0;
  int ReflectionSource = SCENE;
  bool Glitter = true;
  bool HighlightRollOff = true;
  double SlopeVariance[3] = { 0.0, 0.0, 0.0 };
  double FoamDepth = 0.0;
  bool FoamFitsScene = false;
  double FoamStretch = 0.0;
  double FoamColor[3] = { 0.95, 0.97, 1.0 };
  bool Shadows = false;
  double Caustics = 0.0;
  double LightShafts = 0.0;
  double DataOpacity = 1.0;
  double Opacity = 1.0;
  double Depth;
  bool Sea = false;
  double WindSpeed = 5.0;
  double WindDirection = 0.0;
  double Fetch = 10000.0;
  int SeaModel = JONSWAP;
  double PeakEnhancement = 3.3;
  int Seed = 1;
  int SeaTileSize = 256;
  double SeaTileLength = 0.0;
  double SeaPeriod = 0.0;
  int SeaCascades = 2;
  double SeaChoppiness = 1.0;
  bool Whitecaps = false;
  double WhitecapLifeTime = 3.5;
  bool WaveGeometry = false;
  int WaveGridSize = 256;
  int Lookup = RAY_TRACED;
  double OffsetScale = 0.3;
  int RayTraceSteps = 16;
  int RayTraceProbes = 6;
  int RayTraceRays = 4;
  int RayTraceLayers = 1;
  double RayTraceFootprint = 1.0;
  int Output = COLOR;
};

#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif
#endif
