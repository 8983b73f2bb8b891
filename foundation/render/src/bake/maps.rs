//! The maps of a fine mesh for a coarse one, and the files that show them.

use std::collections::{BTreeMap, BTreeSet};

use ga_image::picture::Picture;
use ga_image::png;
use ga_mesh::bake::{Bake, Coarse, Fine, OcclusionOptions, Options};
use ga_mesh::gltf::{self, Document};
use ga_mesh::normals::vertex_normals;
use ga_mesh::{Image, Material, Mesh, MeshAtlas, Normals, Texture, atlas, bounds, obj, tangents};
use ga_runtime::vga3::Vector;
use serde::Serialize;

use super::colour::MeshColours;
use super::error::MapsError;
use super::picture::{HeightRange, colour_picture, height_picture, normal_picture, share_picture};

/// What a map holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum MapKind {
    /// Normals in the tangent frames of the coarse mesh, y up.
    Normal,
    /// Heights above the coarse mesh, 16 bits.
    Displacement,
    /// Colours, sRGB.
    Colour,
    /// The part of the sky that is seen.
    Occlusion,
}

impl MapKind {
    /// The name, as `normal`.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Normal => "normal",
            Self::Displacement => "displacement",
            Self::Colour => "colour",
            Self::Occlusion => "occlusion",
        }
    }

    /// The name of the file of the map, as `normal.png`.
    #[must_use]
    pub fn file(self) -> String {
        format!("{}.png", self.name())
    }
}

/// How maps are made.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct MapsOptions {
    /// The atlas of a coarse mesh without texture coordinates. Its size is that of the maps.
    pub atlas: atlas::Options,
    /// Make an atlas even if the coarse mesh has texture coordinates.
    pub unwrap: bool,
    /// The cage distance, as that of [`Options::cage_distance`].
    pub cage_distance: Option<f64>,
    /// The rays of the map of occlusion.
    pub occlusion: OcclusionOptions,
}

/// Maps, and the coarse mesh that they are for.
#[derive(Clone, Debug)]
pub struct Maps {
    /// The maps as pictures.
    pub pictures: BTreeMap<MapKind, Picture>,
    /// The coarse mesh in triangles, with texture coordinates, normals and tangents.
    pub coarse: Mesh,
    /// What is known of them.
    pub report: MapsReport,
}

/// What is known of maps and the coarse mesh.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct MapsReport {
    /// The side of the maps, in texels.
    pub size: u32,
    /// Triangles of the fine mesh.
    pub fine_triangles: usize,
    /// Triangles of the coarse mesh.
    pub coarse_triangles: usize,
    /// Whether a new atlas was made.
    pub unwrapped: bool,
    /// How many charts the atlas has.
    pub charts: usize,
    /// The part of the texels whose centres lie in a triangle.
    pub utilisation: f64,
    /// The area-weighted L2 stretch; 1 for an isometric map.
    pub stretch: f64,
    /// The greatest L2 stretch of a triangle.
    pub stretch_max: f64,
    /// Triangles whose image is folded over or has no area.
    pub flipped: usize,
    /// Texels that two triangles claim.
    pub overlapping: usize,
    /// Texels that show a point of the surface.
    pub covered_texels: usize,
    /// Those for which the nearest point was taken, as there was none along the normal.
    pub nearest_texels: usize,
    /// What the numbers of the displacement map mean.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub displacement: Option<HeightRange>,
}

impl Maps {
    /// The names of the files of a coarse mesh beside its maps.
    pub const MESH_FILES: [&str; 3] = ["coarse.obj", "coarse.mtl", "coarse.glb"];

    /// Bakes maps of these kinds. `begin` is told the name of each step as it begins.
    ///
    /// # Errors
    ///
    /// [`MapsError`]; [`MapsError::NoColours`] where a map of colours is asked for and `colours`
    /// are not given.
    ///
    /// # Examples
    ///
    /// ```
    /// use std::collections::BTreeSet;
    ///
    /// use ga_mesh::{atlas, obj};
    /// use ga_render::bake::{MapKind, Maps, MapsOptions};
    ///
    /// let coarse = obj::decode(b"v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n")?;
    /// let fine = obj::decode(b"v 0 0 0.01\nv 1 0 0.01\nv 1 1 0.01\nv 0 1 0.01\nf 1 2 3 4\n")?;
    /// let atlas = atlas::Options { size: 32, ..Default::default() };
    /// let options = MapsOptions { atlas, ..Default::default() };
    /// let kinds = BTreeSet::from([MapKind::Displacement]);
    /// let maps = Maps::bake(&fine, &coarse, None, &kinds, &options, |_| ())?;
    /// let range = maps.report.displacement.ok_or("no map")?;
    /// assert!((range.maximum - 0.01).abs() < 1e-6);
    /// assert_eq!(maps.files()?.len(), 4);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn bake(
        fine: &Mesh,
        coarse: &Mesh,
        colours: Option<&MeshColours>,
        kinds: &BTreeSet<MapKind>,
        options: &MapsOptions,
        mut begin: impl FnMut(&'static str),
    ) -> Result<Self, MapsError> {
        begin("atlas");
        let margin = options.atlas.margin_texels;
        let placed = MeshAtlas::new(coarse, &options.atlas, options.unwrap, margin);
        let placed = placed.map_err(MapsError::Atlas)?;
        let coarse = with_tangents(placed.mesh)?;
        begin("hierarchy");
        let fine = Fine::from_mesh(fine).map_err(MapsError::Fine)?;
        begin("projection");
        let mut projection = Options::with_size(options.atlas.size);
        projection.cage_distance = options.cage_distance;
        let surface = Coarse::from_mesh(&coarse, 0).map_err(MapsError::Coarse)?;
        let bake = Bake::new(&surface, &fine, &projection).map_err(MapsError::Projection)?;

        let mut pictures = BTreeMap::new();
        let mut displacement = None;
        for &kind in kinds {
            begin(kind.name());
            let picture = match kind {
                MapKind::Normal => normal_picture(&bake.normals()),
                MapKind::Displacement => {
                    let (picture, range) = height_picture(&bake.displacement(), diagonal(&coarse));
                    displacement = Some(range);
                    picture
                }
                MapKind::Colour => {
                    let colours = colours.ok_or(MapsError::NoColours)?;
                    colour_picture(&bake.colour(|point| colours.at(point)))
                }
                MapKind::Occlusion => {
                    let occlusion = bake.occlusion(&options.occlusion);
                    share_picture(&occlusion.map_err(MapsError::Occlusion)?)
                }
            };
            pictures.insert(kind, picture);
        }
        let report = MapsReport {
            size: options.atlas.size,
            fine_triangles: fine.bvh().triangle_count(),
            coarse_triangles: coarse.faces().len(),
            unwrapped: placed.is_new,
            charts: placed.report.charts,
            utilisation: placed.report.utilisation,
            stretch: placed.report.stretch_l2,
            stretch_max: placed.report.stretch_max,
            flipped: placed.report.flipped,
            overlapping: placed.report.overlapping_texels,
            covered_texels: bake.covered_texels(),
            nearest_texels: bake.nearest_texels(),
            displacement,
        };
        Ok(Self {
            pictures,
            coarse,
            report,
        })
    }

    /// The names and contents of the maps as PNG, and of the coarse mesh as OBJ with MTL, which
    /// names the maps, and as GLB, which contains them.
    ///
    /// # Errors
    ///
    /// [`MapsError::Picture`], [`MapsError::Mesh`] and [`MapsError::Format`].
    pub fn files(&self) -> Result<Vec<(String, Vec<u8>)>, MapsError> {
        let mut files = Vec::new();
        let mut embedded = BTreeMap::new();
        for (&kind, picture) in &self.pictures {
            let bytes = png::encode(picture)?;
            let image = Image::Embedded {
                media_type: "image/png".into(),
                bytes: bytes.as_slice().into(),
            };
            embedded.insert(kind, image);
            files.push((kind.file(), bytes));
        }
        let named = embedded
            .keys()
            .map(|kind| (*kind, Image::File(kind.file())));
        let mesh = self.with_maps(&named.collect())?;
        files.extend(obj::encode_files(&mesh, "coarse"));
        let document = Document::from_mesh(&self.with_maps(&embedded)?)?;
        files.push(("coarse.glb".into(), gltf::encode(&document)?));
        Ok(files)
    }

    /// The coarse mesh with a material that shows the maps.
    fn with_maps(&self, images: &BTreeMap<MapKind, Image>) -> Result<Mesh, MapsError> {
        let texture = |kind| images.get(&kind).cloned().map(Texture::new);
        let material = Material {
            base_colour_texture: texture(MapKind::Colour),
            normal_texture: texture(MapKind::Normal),
            occlusion_texture: texture(MapKind::Occlusion),
            ..Material::named("baked")
        };
        let of_faces = vec![Some(0); self.coarse.faces().len()];
        Ok(self
            .coarse
            .clone()
            .with_materials(vec![material], of_faces)?)
    }
}

/// The mesh with tangents, and with smooth normals where it has none.
fn with_tangents(mut mesh: Mesh) -> Result<Mesh, MapsError> {
    if mesh.normals().is_none() {
        let positions: Vec<[f64; 3]> = mesh.coordinates().collect();
        let normals = vertex_normals(&positions, &mesh.triangles());
        let normals: Vec<Vector<f64>> = normals.into_iter().map(Into::into).collect();
        let normals = Normals::of_directions(&normals, mesh.faces());
        mesh = mesh.with_normals(normals)?;
    }
    let tangents = tangents::mikktspace(&mesh, 0)?;
    Ok(mesh.with_tangents(tangents)?)
}

/// The diagonal of the bounding box of the faces.
fn diagonal(mesh: &Mesh) -> f64 {
    let corners = mesh.faces().corners().iter();
    let [low, high] =
        bounds(corners.map(|&v| mesh.positions()[v as usize].into())).unwrap_or_default();
    low.distance(high)
}
