//! `nullcone mesh bake`: maps of a fine mesh for a coarse one.

mod coarse;
mod report;

use std::collections::BTreeSet;
use std::path::PathBuf;
use std::time::Instant;

use anyhow::{Context as _, Result};
use clap::ValueEnum;
use clap::builder::RangedI64ValueParser;
use ga_mesh::bake::{Bake, Coarse as BakedCoarse, Fine, OcclusionOptions, Options};
use ga_mesh::{Image, atlas};
use ga_render::bake::{MeshColours, colour_picture, height_picture, normal_picture, share_picture};

use crate::frame::{Command, Context};
use crate::{mesh_file, output};
use coarse::{Coarse, Images};
use report::{Report, Steps};

/// Bake the details of a fine mesh into maps for a coarse one.
///
/// For instance
///
///   nullcone mesh bake --fine scan.obj --coarse game.obj --maps normal,colour --out baked
///
/// writes the maps as PNG files and coarse.obj, coarse.mtl and coarse.glb, which show them. The
/// coarse mesh keeps its texture coordinates if every corner has one; otherwise an atlas is made.
/// Colours are those of the vertices of the fine mesh, or else those of its materials and their
/// pictures. With --json, the report has the time of each step, the figures of the atlas (charts,
/// utilisation, stretch, flipped, overlapping) and the range of the displacement; "files" are
/// the names in the folder.
#[derive(Clone, Debug, clap::Args)]
#[command(verbatim_doc_comment)]
pub(crate) struct Arguments {
    /// The mesh with the details.
    #[arg(long, value_name = "FILE")]
    fine: PathBuf,
    /// The mesh that the maps are for.
    #[arg(long, value_name = "FILE")]
    coarse: PathBuf,
    /// The folder for the maps and the coarse mesh.
    #[arg(long, value_name = "DIR")]
    out: PathBuf,
    /// The side of the maps, in texels; at most 8192.
    #[arg(long, default_value_t = 1024, value_parser = size())]
    size: u32,
    /// The maps, separated by commas.
    #[arg(
        long,
        value_enum,
        value_delimiter = ',',
        default_value = "normal,displacement,colour"
    )]
    maps: Vec<Map>,
    /// Make new texture coordinates even if the coarse mesh has its own.
    #[arg(long)]
    unwrap: bool,
    /// In a new atlas, texels around each chart that no other chart claims.
    #[arg(long, default_value_t = 1, value_name = "TEXELS")]
    margin: u32,
    /// How far from the coarse mesh the fine one is looked for along normals, in the unit of the
    /// meshes; 2 % of the diagonal of the coarse mesh by default.
    #[arg(long)]
    distance: Option<f64>,
    /// Rays for each texel of the occlusion map.
    #[arg(long, default_value_t = 32)]
    rays: u32,
    /// Chooses the directions of these rays.
    #[arg(long, default_value_t = 0)]
    seed: u64,
    /// How far away a surface still hides the sky, in the unit of the meshes; any distance by
    /// default.
    #[arg(long, value_name = "DISTANCE")]
    occlusion_distance: Option<f64>,
}

/// A map.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, ValueEnum)]
enum Map {
    /// Normals in the tangent frames of the coarse mesh, y up.
    Normal,
    /// Heights above the coarse mesh, 16 bits.
    Displacement,
    /// Colours, sRGB.
    #[value(alias = "color")]
    Colour,
    /// The part of the sky that is seen.
    Occlusion,
}

impl Map {
    fn name(self) -> &'static str {
        match self {
            Self::Normal => "normal",
            Self::Displacement => "displacement",
            Self::Colour => "colour",
            Self::Occlusion => "occlusion",
        }
    }

    fn file(self) -> &'static str {
        match self {
            Self::Normal => "normal.png",
            Self::Displacement => "displacement.png",
            Self::Colour => "colour.png",
            Self::Occlusion => "occlusion.png",
        }
    }
}

/// The greatest side of maps, in texels. A bake takes up to about 100 bytes for each texel, 6 GiB
/// with this side.
const MOST_TEXELS: i64 = 8192;

/// Sizes that maps may have.
fn size() -> RangedI64ValueParser<u32> {
    clap::value_parser!(u32).range(1..=MOST_TEXELS)
}

/// The files beside the maps.
const MESH_FILES: [&str; 3] = ["coarse.obj", "coarse.mtl", "coarse.glb"];

impl Command for Arguments {
    type Report = Report;

    fn run(&self, context: &Context) -> Result<Report> {
        let arguments = self;
        let maps: BTreeSet<Map> = arguments.maps.iter().copied().collect();
        let names: Vec<&str> = maps
            .iter()
            .map(|map| map.file())
            .chain(MESH_FILES)
            .collect();
        let mut files = context.files([&arguments.fine, &arguments.coarse])?;
        files.write_folder("--out", &arguments.out, names)?;
        let begin = Instant::now();
        let progress = context.progress(maps.len() as u64 + 6);
        let mut steps = Steps::new(&progress);

        steps.begin("read");
        let (fine_mesh, mut warnings) = mesh_file::read(&arguments.fine)?;
        let (coarse_mesh, of_coarse) = mesh_file::read(&arguments.coarse)?;
        let (colours, missing) = match maps.contains(&Map::Colour) {
            true => {
                let found = MeshColours::new(&fine_mesh, arguments.fine.parent());
                let found = found.with_context(|| arguments.fine.display().to_string())?;
                (Some(found.0), found.1)
            }
            false => (None, Vec::new()),
        };
        let missing = missing.iter().map(ToString::to_string);
        for warning in mesh_file::missing_parts(&arguments.fine, missing) {
            // The reader of OBJ files says as well which pictures are missing.
            if !warnings.contains(&warning) {
                warnings.push(warning);
            }
        }
        warnings.extend(of_coarse);

        steps.begin("atlas");
        let options = atlas::Options {
            size: arguments.size,
            margin_texels: arguments.margin,
            ..atlas::Options::default()
        };
        let coarse = Coarse::new(&coarse_mesh, &options, arguments.unwrap)
            .with_context(|| format!("{}: no texture", arguments.coarse.display()))?;

        steps.begin("hierarchy");
        let fine = Fine::from_mesh(&fine_mesh)
            .with_context(|| format!("{}: nothing to bake", arguments.fine.display()))?;

        steps.begin("projection");
        let mut options = Options::with_size(arguments.size);
        options.cage_distance = arguments.distance;
        let surface = BakedCoarse::from_mesh(&coarse.mesh, 0)
            .with_context(|| format!("{}: nothing to bake", arguments.coarse.display()))?;
        let named = || arguments.coarse.display().to_string();
        let bake = Bake::new(&surface, &fine, &options).with_context(named)?;

        let [low, high] = coarse.mesh.bounds().unwrap_or_default();
        let squares = [0, 1, 2].map(|axis: usize| (high[axis] - low[axis]).powi(2));
        let diagonal = squares.iter().sum::<f64>().sqrt();
        let mut pictures = Vec::new();
        let mut range = None;
        for &map in &maps {
            steps.begin(map.name());
            let picture = match map {
                Map::Normal => normal_picture(&bake.normals()),
                Map::Displacement => {
                    let (picture, found) = height_picture(&bake.displacement(), diagonal);
                    range = Some(found.into());
                    picture
                }
                Map::Colour => {
                    let colours = colours.as_ref().context("no colours were read")?;
                    colour_picture(&bake.colour(|point| colours.at(point)))
                }
                Map::Occlusion => {
                    let mut options = OcclusionOptions::default();
                    options.rays = arguments.rays;
                    options.seed = arguments.seed;
                    options.distance = arguments.occlusion_distance.unwrap_or(f64::INFINITY);
                    let occlusion = bake.occlusion(&options);
                    share_picture(&occlusion.with_context(|| arguments.fine.display().to_string())?)
                }
            };
            pictures.push((map, picture));
        }

        steps.begin("encode");
        let mut files: Vec<(String, Vec<u8>)> = Vec::new();
        for (map, picture) in &pictures {
            files.push((map.file().into(), ga_image::png::encode(picture)?));
        }
        let named = |map: Map| maps.contains(&map).then(|| Image::File(map.file().into()));
        let embedded = |map: Map| {
            let place = pictures.iter().position(|(other, _)| *other == map)?;
            Some(Image::Embedded {
                media_type: "image/png".into(),
                bytes: files[place].1.as_slice().into(),
            })
        };
        let mut mesh_files = coarse.obj(images(named), "coarse")?;
        mesh_files.push(("coarse.glb".into(), coarse.glb(images(embedded))?));
        files.extend(mesh_files);

        steps.begin("write");
        let names: Vec<String> = files.iter().map(|(name, _)| name.clone()).collect();
        let files = files.into_iter();
        let files = files.map(|(name, contents)| (arguments.out.join(name), contents));
        let files: Vec<(PathBuf, Vec<u8>)> = files.collect();
        mesh_file::check_parts("--out", &[&arguments.fine, &arguments.coarse], &files)?;
        output::write_together(files)?;

        let seconds = steps.finish(begin);
        drop(progress);
        Ok(Report {
            folder: arguments.out.clone(),
            warnings,
            seconds,
            size: arguments.size,
            fine_triangles: fine_mesh.triangles().len(),
            coarse_triangles: coarse.mesh.faces().len(),
            unwrapped: coarse.unwrapped,
            charts: coarse.report.charts,
            utilisation: coarse.report.utilisation,
            stretch: coarse.report.stretch_l2,
            stretch_max: coarse.report.stretch_max,
            flipped: coarse.report.flipped,
            overlapping: coarse.report.overlapping_texels,
            covered_texels: bake.covered_texels(),
            nearest_texels: bake.nearest_texels(),
            displacement: range,
            files: names,
        })
    }
}

/// The maps that a material shows.
fn images(image: impl Fn(Map) -> Option<Image>) -> Images {
    Images {
        colour: image(Map::Colour),
        normal: image(Map::Normal),
        occlusion: image(Map::Occlusion),
    }
}
