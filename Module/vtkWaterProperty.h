// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkWaterProperty
 * @brief   how a water surface looks
 *
 * The colour of a water pixel is the reflection, weighted by the reflectance, over what is seen
 * through the surface: the water's own colour, or, with Refraction, the scene beneath. Setters
 * refuse a value outside the stated range: an error names the value and the range, and the last
 * good value stays.
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
   * Where the reflectance comes from: FRESNEL (exact, unpolarised, by IndexOfRefraction and the
   * angle of view; from under water with total internal reflection) or CONSTANT (Reflectance).
   * Default is FRESNEL.
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
   * Share of the reflection in the pixel when ReflectanceMode is CONSTANT, in [0, 1]. 1 is a
   * perfect mirror: the pixel is the reflection and nothing else. At 0 no reflection is rendered.
   * Default is 1.
   */
  void SetReflectance(double reflectance);
  vtkGetMacro(Reflectance, double);
  ///@}

  ///@{
  /**
   * Index of refraction of the water against what lies above it, in [1, 10]. Default is 1.333.
   */
  void SetIndexOfRefraction(double index);
  vtkGetMacro(IndexOfRefraction, double);
  ///@}

  ///@{
  /**
   * Whether the scene beyond the surface is seen through it: refracted by Snell's law, dimmed by
   * Absorption and Scattering on its way through the water, and turning into DeepColor with the
   * length of the way. It is taken from the main picture, without another view of the scene: the
   * water is then drawn after all other opaque props, and translucent ones and volumes are not seen
   * through it. Has no effect on water with an Opacity below 1. Default is off: DeepColor alone.
   */
  void SetRefraction(bool refraction);
  vtkGetMacro(Refraction, bool);
  vtkBooleanMacro(Refraction, bool);
  ///@}

  ///@{
  /**
   * Absorption of the water, 1/m at 650, 550 and 450 nm (red, green, blue): finite and not
   * negative; the scene's unit is taken for a metre. After a way of x metres the part
   * exp(-(absorption + scattering) x) of the light is left. Default is that of a clear lake
   * (water_preset_default).
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
   * Scattering of the water, 1/m at 650, 550 and 450 nm (red, green, blue): finite and not
   * negative. Only scattering out of the line of sight counts: of real water the part scattered
   * backward. Default is that of a clear lake (water_preset_default).
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
   * Sets Absorption and Scattering to those of one of Jerlov's optical water types: "I", "IA",
   * "IB", "II", "III" (ocean), "1C", "3C", "5C", "7C", "9C" (coast, clear to turbid), and
   * DeepColorMode to MEDIUM.
   *
   * Returns false, with an error, for another name. GetWaterType is the type that has this
   * Absorption and Scattering, however they were set; nullptr: none has.
   *
   * Source: Jerlov 1976, "Marine Optics", table XXVII.
   */
  bool SetWaterType(const char* name);
  const char* GetWaterType() const;
  ///@}

  ///@{
  /**
   * Sets everything to a water of this name: "pool", "lake", "clear tropical", "ocean wind 5",
   * "ocean wind 10", "ocean wind 15" (m/s), "turbid river" or "mirror floor". GetPresetSource says
   * where its numbers come from (nullptr for another name). Lookup, its numbers, Output, Opacity,
   * Seed, SeaTileSize and SeaPeriod stay.
   *
   * Returns false, with an error, for another name; then nothing changes. GetPreset is the preset
   * that would change nothing now: the last one, until something that it sets has another value;
   * nullptr: each would change something.
   */
  bool SetPreset(const char* name);
  const char* GetPreset() const;
  ///@}
  static int GetNumberOfPresets();
  static const char* GetPresetName(int number); // nullptr from the number on
  static const char* GetPresetSource(const char* name);

  enum DeepColorModes
  {
    MEDIUM = 0,
    GIVEN = 1
  };

  ///@{
  /**
   * Where the colour of infinitely deep water comes from. MEDIUM: the share of the light that
   * Absorption and Scattering send back up, 0.33 b / (a + b), under the renderer's distant
   * lights (not positional ones; a headlight stands where the eye is) and background. GIVEN:
   * DeepColor, which no light changes. Default is MEDIUM.
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
   * Colour of infinitely deep water: what is seen where the water does not reflect, and with
   * Refraction where it is deep. Red, green, blue, each in [0, 1]. Setting it sets DeepColorMode to
   * GIVEN. While that is MEDIUM, the default, GetDeepColor returns the colour under white daylight,
   * and a colour of the actor's vtkProperty takes its place.
   */
  void SetDeepColor(double red, double green, double blue);
  void SetDeepColor(const double rgb[3]) { this->SetDeepColor(rgb[0], rgb[1], rgb[2]); }
  vtkGetVector3Macro(DeepColor, double);
  ///@}

  ///@{
  /**
   * Metres per unit of the scene, in [1e-9, 1e9]: all lengths of this class are metres, and shown
   * in the scene's unit. 0 is automatic: a scene of 400 to 2000 units across (a preset may
   * have another range: a pool 8 to 40) is one in metres, a smaller one counts as 200 to 400 m, a
   * larger one as 2000 m, and waves shorter than 1/400 of the scene are not shown. Then
   * GetWaveHeight follows what is shown. Without a preset, light is taken as if the deepest bed
   * were 30 m deep, or 60 m in a scene ten times as wide as deep: heights of a map have a scale of
   * their own. Default is 1.
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
   * Depth of water over which its reflection begins at a shore, m: finite and not negative. Only
   * with Refraction, which knows the depth. Default is 0.05.
   */
  void SetShoreSoftness(double depth);
  vtkGetMacro(ShoreSoftness, double);
  ///@}

  enum ReflectionSources
  {
    SCENE = 0,
    ENVIRONMENT = 1
  };

  ///@{
  /**
   * What is reflected: the SCENE, rendered once more by a mirrored camera; or the static
   * ENVIRONMENT, for which nothing is rendered: EnvironmentTexture, or without one the sky that VTK
   * shows: a skybox, or the renderer's background. Default is SCENE.
   */
  void SetReflectionSource(int source);
  vtkGetMacro(ReflectionSource, int);
  void SetReflectionSourceToScene() { this->SetReflectionSource(SCENE); }
  void SetReflectionSourceToEnvironment() { this->SetReflectionSource(ENVIRONMENT); }
  const char* GetReflectionSourceAsString() const;
  ///@}

  ///@{
  /**
   * The picture of the surroundings, in latitude and longitude, as vtkSkybox with the projection
   * Sphere has it; it lies as the renderer's EnvironmentUp and EnvironmentRight say. It is also the
   * sky of rays that leave the mirrored picture, of an eye under water, and of this water in
   * another water's reflection. Without one these see what VTK shows: a skybox, or the renderer's
   * background. A cube map is refused with an error. Default is nullptr.
   */
  void SetEnvironmentTexture(vtkTexture* texture);
  vtkTexture* GetEnvironmentTexture() const;
  ///@}

  ///@{
  /**
   * The sun's glitter on waves, and on water with a SlopeVariance, by the distribution of the
   * slopes. The sun is the brightest scene light of the renderer; a headlight has none. Default is
   * on.
   *
   * Source: Cox and Munk 1954, "Measurement of the Roughness of the Sea Surface from Photographs of
   * the Sun's Glitter".
   */
  void SetGlitter(bool glitter);
  vtkGetMacro(Glitter, bool);
  vtkBooleanMacro(Glitter, bool);
  ///@}

  ///@{
  /**
   * Glitter that is brighter than white rolls off towards it, so that it keeps its shape and the
   * sun's colour; what is up to 0.6 of the room left up to white is shown as it is. Off where a
   * pass of the renderer may map tones, whatever is set here. Default is on.
   */
  void SetHighlightRollOff(bool rolls);
  vtkGetMacro(HighlightRollOff, bool);
  vtkBooleanMacro(HighlightRollOff, bool);
  ///@}

  ///@{
  /**
   * Variance of the slopes of waves that are too small to be given one by one: along and across a
   * direction (degrees), in [0, 1e6]. SetSlopeVarianceToWind takes Cox and Munk's
   * measured ones for a wind speed in [0.1, 100] m/s that blows to a direction. Default is 0.
   */
  void SetSlopeVariance(double along, double across, double direction = 0.0);
  void SetSlopeVarianceToWind(double speed, double direction = 0.0);
  void GetSlopeVariance(double variance[3]) const; // along, across, direction
  ///@}

  ///@{
  /**
   * Foam where the water is shallower than FoamDepth, m: finite and not negative; with Refraction.
   * It covers the waterline, and bands of it travel towards the shore, the same every 12 s. Default
   * is 0: none.
   */
  void SetFoamDepth(double depth);
  vtkGetMacro(FoamDepth, double);
  ///@}

  ///@{
  /**
   * Foam on crests whose points stand closer than FoamStretch times their distance at rest, in
   * [0, 1]: those of steep waves. Default is 0: none.
   */
  void SetFoamStretch(double stretch);
  vtkGetMacro(FoamStretch, double);
  ///@}

  ///@{
  /**
   * Colour of the foam, red, green, blue, each in [0, 1]; it is lit by the sun. Default is (0.95,
   * 0.97, 1).
   */
  void SetFoamColor(double red, double green, double blue);
  void SetFoamColor(const double rgb[3]) { this->SetFoamColor(rgb[0], rgb[1], rgb[2]); }
  vtkGetVector3Macro(FoamColor, double);
  ///@}

  ///@{
  /**
   * Shadows of things on the water's glitter and foam: a ray to the sun is traced in the mirrored
   * view. It is in shadow where it goes through a surface that the view shows, from either side,
   * or passes an upright edge by less than a twentieth of the distance behind it. What the view
   * does not show throws no shadow: things out of the picture, and sides that face away from the
   * mirrored eye. Needs Lookup RAY_TRACED, and can more than double a software
   * renderer's frame. Default is off.
   */
  void SetShadows(bool shadows);
  vtkGetMacro(Shadows, bool);
  vtkBooleanMacro(Shadows, bool);
  ///@}

  ///@{
  /**
   * Strength of the light that waves gather on what lies under them, in [0, 1]; with Refraction,
   * waves and a sun (a scene light). At 1 the light is that of the waves' slopes: it is followed
   * from the surface to the bed, none is lost, and only the sun's disc, the picture's pixels and
   * the water's smallest waves blur it. Waves that move the surface light the bed as if they lay in
   * the plane. A GPU that gives no float textures is an ErrorEvent, once, and the light is that of
   * calm water. Default is 0: none. Source: Shah et al. 2007, "Caustics Mapping".
   */
  void SetCaustics(double strength);
  vtkGetMacro(Caustics, double);
  ///@}

  ///@{
  /**
   * How much of what is seen in the water is the colour of the mesh's scalars, in [0, 1], where the
   * actor's mapper shows scalars through its lookup table. At 1 they are the colour of the water
   * itself, and hide what lies under it; below 1 they are blended with it. What is reflected,
   * glitter and foam come on top: without these (SetReflectance(0), GlitterOff) the picture shows
   * the lookup table's colours, unlit. Default is 1.
   */
  void SetDataOpacity(double opacity);
  vtkGetMacro(DataOpacity, double);
  ///@}

  ///@{
  /**
   * Opacity of the surface for plain alpha blending with what lies behind it, in [0, 1]. Below 1
   * the water is drawn with the translucent geometry. Default is 1.
   */
  void SetOpacity(double opacity);
  vtkGetMacro(Opacity, double);
  ///@}

  ///@{
  /**
   * Waves: any number of sines, the height being amplitude times the sine of k . x + phase - omega
   * t, x in the plane's own axes, omega from the dispersion relation of Depth. With waves the
   * surface is a flat sheet with the waves' normals, or, with WaveGeometry, displaced.
   *
   * amplitude  m, half the height from trough to crest, finite and not negative
   * wavelength m, finite and greater than 0; the scene's unit is taken for a metre
   * direction  degrees; the wave travels to there, from the plane's first axis towards the second
   * phase      degrees, at the axes' origin and time 0
   * steepness  [0, 1]: 0 is a sine, 1 Gerstner's wave with cusps; the sum of 2 pi amplitude
   *            steepness / wavelength over all waves must not exceed 1, or the surface would fold
   *
   * Returns the wave's number, or -1 when it was refused (with an error that names the value).
   * GetWave gives the five numbers again; false when there is no such wave.
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
   * Sets a wave to other numbers (those of AddWave), or removes it; the waves after it then count
   * one less. The wave's number must lie in [0, GetNumberOfWaves() - 1]. Returns false, with an
   * error, when it does not or when the new numbers are refused; then no wave changes.
   */
  bool SetWave(int number, double amplitude, double wavelength, double direction = 0.0,
    double phase = 0.0, double steepness = 0.0);
  bool RemoveWave(int number);
  ///@}

  /**
   * Root mean square slope of the waves together, those of the sea included that its tile holds.
   */
  double GetSlopeRMS() const;

  /**
   * Sum of the waves' amplitudes, m, and, where WaveGeometry moves a wind sea, 6 standard
   * deviations of its height: displaced, no point is higher, or deeper; of the sea's crests one in
   * 6e7.
   */
  double GetWaveHeightMax() const;

  ///@{
  /**
   * One or two normal maps that move over the water, in addition to other waves. A texture's red
   * and green are the normal's parts along the plane's axes and blue the one up, from -1 to 1 as 0
   * to 255: 3 or 4 channels of 8 bits, from 2 x 2 to 4096 x 4096; nullptr is a built-in map of
   * ripples with an rms slope of 0.1. They have no heights: GetWaveHeight and GetWaveNormal leave
   * them out.
   *
   * size       m of water that the map covers, in [1e-6, 1e9]
   * speed      m/s with which it moves, finite
   * direction  degrees; it moves to there, from the plane's first axis towards the second
   * strength   factor of its slopes, in [-1000, 1000]
   *
   * AddNormalMap returns the map's number, or -1 when it was refused (with an error that names the
   * value). GetNormalMap gives the four numbers again; false when there is no such map.
   */
  int AddNormalMap(vtkTexture* texture, double size, double speed = 0.0, double direction = 0.0,
    double strength = 1.0);
  void RemoveAllNormalMaps();
  int GetNumberOfNormalMaps() const;
  bool GetNormalMap(int number, double map[4]) const;
  vtkTexture* GetNormalMapTexture(
    int number) const; // also the built-in one; nullptr: no such reflection texture
  ///@}

  ///@{
  /**
   * Whether the waves of AddWave and the wind sea displace the surface (normal maps do not): up and
   * down, and, steep ones and the sea (SeaChoppiness), to and fro. Off is a flat
   * sheet with their normals: cheaper, and right where waves are low against what stands in them.
   * On, the own sheet becomes a grid over what the eye sees of it; of a mapper of the user's the
   * points are displaced as they are, so that it needs several to a wave. Has no effect without
   * waves, nor on edges and wide lines. Default is off.
   */
  void SetWaveGeometry(bool geometry);
  vtkGetMacro(WaveGeometry, bool);
  vtkBooleanMacro(WaveGeometry, bool);
  ///@}

  ///@{
  /**
   * Cells along a side of that grid, in [16, 2048]: as many across the view as into its depth.
   * Waves with fewer than four cells keep part of their height, those with fewer than two only
   * their normals. Default is 256.
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
   * A wind sea: random waves with the spectrum that the wind makes, on square tiles that repeat
   * in both directions (SeaCascades), added to the waves of AddWave. The surface between a tile's
   * points is bilinear, in heights and in slopes, for GetWaveHeight and in the picture. Waves that
   * are too short for a pixel, or for the tiles, roughen the reflection. Default is off.
   *
   * Source: Tessendorf 2001, "Simulating Ocean Water".
   */
  void SetSea(bool sea);
  vtkGetMacro(Sea, bool);
  vtkBooleanMacro(Sea, bool);
  ///@}

  ///@{
  /**
   * Speed of the wind at 10 m, m/s in [0.1, 100]. Default is 5.
   */
  void SetWindSpeed(double speed);
  vtkGetMacro(WindSpeed, double);
  ///@}

  ///@{
  /**
   * Where the wind blows to, degrees from the plane's first axis towards the second: finite.
   * Default is 0.
   */
  void SetWindDirection(double direction);
  vtkGetMacro(WindDirection, double);
  ///@}

  ///@{
  /**
   * Open water upwind, m: at least 1; infinity is a fully developed sea. Default is 10000.
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
   * The sea's spectrum. JONSWAP: a growing sea, with the TMA factor for finite Depth. PHILLIPS: a
   * fully developed sea in deep water, with as many waves against the wind as with it; Fetch and
   * PeakEnhancement have no effect. Default is JONSWAP.
   *
   * Sources: Hasselmann et al. 1973, "Measurements of Wind-Wave Growth and Swell Decay during the
   * Joint North Sea Wave Project"; Bouws et al. 1985, "Similarity of the Wind Wave Spectrum in
   * Finite Depth Water 1" (TMA); Donelan, Hamilton and Hui 1985, "Directional Spectra of
   * Wind-Generated Waves" (directions); Phillips's as in Tessendorf 2001.
   */
  void SetSeaModel(int model);
  vtkGetMacro(SeaModel, int);
  void SetSeaModelToJONSWAP() { this->SetSeaModel(JONSWAP); }
  void SetSeaModelToPhillips() { this->SetSeaModel(PHILLIPS); }
  const char* GetSeaModelAsString() const;
  ///@}

  ///@{
  /**
   * How much higher the JONSWAP spectrum's peak is than that of a developed sea, in [1, 20]: 1 is
   * one. Default is 3.3, the mean of the measurements.
   */
  void SetPeakEnhancement(double enhancement);
  vtkGetMacro(PeakEnhancement, double);
  ///@}

  ///@{
  /**
   * Seed of the sea's random numbers, any integer: the same one gives the same sea. Default is 1.
   */
  void SetSeed(int seed);
  vtkGetMacro(Seed, int);
  ///@}

  ///@{
  /**
   * Points of each of the sea's tiles along a side: a power of two in [32, 1024]. The shortest
   * waves are two points long. The time to make a sea goes with the square. Default is 256.
   */
  void SetSeaTileSize(int size);
  vtkGetMacro(SeaTileSize, int);
  ///@}

  ///@{
  /**
   * Length of the first tile's side, m: in [0.001, 1e9], or 0 for 24 times the wavelength of the
   * spectrum's peak (10 times with one cascade), which holds the sea's height within 1 %. Shorter
   * tiles repeat sooner, and lack the waves that are longer than they are; with one cascade they
   * show shorter waves near the eye. GetUsedSeaTileLength tells the length in use. Default is 0.
   */
  void SetSeaTileLength(double length);
  vtkGetMacro(SeaTileLength, double);
  double GetUsedSeaTileLength() const;
  ///@}

  ///@{
  /**
   * Time after which the sea repeats itself exactly, s: finite, not negative; 0 is never. Every
   * wave then has the frequency next to its own that fits. Default is 0.
   */
  void SetSeaPeriod(double period);
  vtkGetMacro(SeaPeriod, double);
  ///@}

  ///@{
  /**
   * Tiles of the sea, in [1, 3], each with a band of the waves: the first with the longest, each
   * other one shorter by the same factor (at most 19 for 256 points), so that a sea reaches down to
   * waves of a few centimetres, and does not repeat as a whole. Where fewer tiles reach waves of
   * 1.7 cm there are fewer: GetUsedSeaCascades tells. The time to make a sea goes with their
   * number; a pixel that is longer than a tile's waves does not look at it. Three show ripples next
   * to the eye. Default is 2.
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
   * How much of its motion to and fro a displaced sea has (WaveGeometry), in [0, 1]: 1 is that of
   * Gerstner's waves, with sharp crests and flat troughs; 0 is up and down alone. Default is 1.
   *
   * Source: Tessendorf 2001, "Simulating Ocean Water" (choppy waves).
   */
  void SetSeaChoppiness(double choppiness);
  vtkGetMacro(SeaChoppiness, double);
  ///@}

  ///@{
  /**
   * Whether a wind sea is white where its crests break: where its points stand closest, on the
   * share of the surface that was measured for the wind (GetWhitecapCover; 0 when they or the sea
   * are off). They have FoamColor, and are there whether or not the surface is displaced. Default
   * is off.
   *
   * Sources: Monahan and O'Muircheartaigh 1980, "Optimal Power-Law Description of Oceanic Whitecap
   * Coverage Dependence on Wind Speed" (the share); Tessendorf 2001 (the place).
   */
  void SetWhitecaps(bool whitecaps);
  vtkGetMacro(Whitecaps, bool);
  vtkBooleanMacro(Whitecaps, bool);
  double GetWhitecapCover() const;
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
   * How a wave's reflection is found in the mirrored view. RAY_TRACED: the reflected ray is walked
   * until it meets what the mirrored view shows. FIXED_OFFSET: the calm reflection, shifted by the
   * normal times OffsetScale (in shares of the picture). VIEW_SCALED_OFFSET: the same over the
   * distance from the eye. MOVED_POINT: the calm reflection of a point that is moved by the normal
   * times OffsetScale (in the scene's unit). The latter three are fast and wrong; most programs use
   * them, and they are here for comparison. Default is RAY_TRACED.
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
   * Factor of the three offset lookups, in [-1000, 1000]. Default is 0.3.
   */
  void SetOffsetScale(double scale);
  vtkGetMacro(OffsetScale, double);
  ///@}

  ///@{
  /**
   * Work of the ray-traced lookup: steps of the march, taken where the ray does not converge at
   * once, in [1, 256]. Default is 16.
   */
  void SetRayTraceSteps(int steps);
  vtkGetMacro(RayTraceSteps, int);
  ///@}

  ///@{
  /**
   * Work of the ray-traced lookup: probes between the water and where the ray converged,
   * in [0, 64]. Default is 6.
   */
  void SetRayTraceProbes(int probes);
  vtkGetMacro(RayTraceProbes, int);
  ///@}

  ///@{
  /**
   * Work of the ray-traced lookup: rays of a pixel whose neighbour shows another colour, in
   * [1, 16]. All other pixels have one. Rough water, whose pixels have several facets, ignores it.
   * So do GPUs, where it costs a quarter of the frame, unless RayTraceLayers is 2. Default is 4.
   */
  void SetRayTraceRays(int rays);
  vtkGetMacro(RayTraceRays, int);
  ///@}

  ///@{
  /**
   * Work of the ray-traced lookup: layers of the mirrored view that rays see, in [1, 2]. With 2 a
   * ray that goes behind the edge of a thing goes on among what is behind there, which is drawn
   * once more for it, whenever the mirrored view is. The
   * reflection texture is twice as fine at 0. Default is 1.
   */
  void SetRayTraceLayers(int layers);
  vtkGetMacro(RayTraceLayers, int);
  ///@}

  ///@{
  /**
   * The waves' slopes are averaged over a square of so many pixels, in [0, 1]. 1: the whole pixel.
   * 0: slopes are those at the pixel's middle; a single frame then flickers where waves are smaller
   * than a pixel, and the mean of many frames (vtkWaterFrameAverage) shows all of them. The
   * reflection texture is twice as fine at 0. Default is 1.
   */
  void SetRayTraceFootprint(double footprint);
  vtkGetMacro(RayTraceFootprint, double);
  ///@}

  ///@{
  /**
   * Steps, probes, rays, layers and footprint at once, by a name, which must be one of these:
   *
   *               steps  probes  rays  layers  footprint
   *     fast          8       3     1       1          1
   *     default      16       6     4       1          1
   *     high         24      12     8       2          1
   *     reference   256      64     1       2          0
   *
   * "high" also multisamples calm water's reflection (vtkWaterReflectionPass::SetMultiSamples).
   * "reference" is for vtkWaterFrameAverage, whose frames are its rays.
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
   * Why a pixel has its colour, as OUTPUT CONFIDENCE shows it: all three channels are this number
   * of 255.
   */
  enum Confidences
  {
    NOT_REFLECTING = 0, // there is no mirrored view
    HIT = 1,            // the ray meets a surface
    SKY = 2,            // the ray leaves the scene within the mirrored view
    OFF_MAP = 3,        // the ray leaves the mirrored view: sky, or the colour at its border
    HIDDEN = 4,         // the ray passes behind something in the mirrored view, whatever it meets
    DOWNWARD = 5        // the ray would meet the water again; it was bounced off once more
  };

  ///@{
  /**
   * What the water shows: its COLOR; the CONFIDENCE of its reflection (Confidences); its LOOKUP:
   * where in the reflection texture a pixel has its colour from, u and v in [0, 1] as 12 bits each:
   * red and the high half of green are u, the rest v; or its REFLECTANCE, in [0, 1] as 16 bits: red
   * is the high byte and green the low one. CONFIDENCE and LOOKUP are of the pixel's mean slope;
   * its roughness has no part in them. Default is COLOR.
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
   * Makes this water look as another does: everything that can be set is copied, textures are
   * shared. nullptr changes nothing.
   */
  void DeepCopy(vtkWaterProperty* other);

  vtkMTimeType GetMTime() override; // of its textures, too

  ///@{
  /**
   * What the module itself reads of the look: all of it at once, the waves of AddWave, and the sea
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
  // Is this water what a preset sets?
  bool IsPreset(const water_preset& preset) const;
  // Is there a wave of this number? Says what there is when not.
  bool HasWave(const char* what, int number);
  // Waves in place of those there are, when they can be. Says what is wrong when not.
  bool UseWaves(std::vector<water_wave>& waves, int number, const char* otherwise);
  // Refuses a colour with a channel outside [0, 1].
  // Returns whether the colour is one.
  bool SetColor(const char* name, double (&member)[3], double red, double green, double blue);
  void UpdateDeepColor();
  void PrintSea(ostream& os, vtkIndent indent) const;
  // Sets one of the sea's numbers when the core finds it good.
  template <typename T>
  void SetOfSea(const char* name, T& member, T value);
  // Sets one of the two when the water has good numbers then.
  void SetMedium(const char* name, double (vtkWaterProperty::*member)[3], const double value[3]);
  void UseMedium(const water_medium& medium);

  struct Internals;
  std::unique_ptr<Internals> Internal;
  int ReflectanceMode = FRESNEL;
  double Reflectance = 1.0;
  double IndexOfRefraction = 1.333;
  bool Refraction = false;
  double Absorption[3] = { 0.0, 0.0, 0.0 };
  double Scattering[3] = { 0.0, 0.0, 0.0 };
  int DeepColorMode = MEDIUM;
  double DeepColor[3] = {};
  double MetresPerUnit = 1.0;
  double ShoreSoftness = 0.05;
  int ReflectionSource = SCENE;
  bool Glitter = true;
  bool HighlightRollOff = true;
  double SlopeVariance[3] = { 0.0, 0.0, 0.0 };
  double FoamDepth = 0.0;
  double FoamStretch = 0.0;
  double FoamColor[3] = { 0.95, 0.97, 1.0 };
  bool Shadows = false;
  double Caustics = 0.0;
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
