//! `nullcone mesh bake`: maps of a fine mesh for a coarse one.

mod report;

use std::collections::BTreeSet;
use std::path::PathBuf;
use std::time::Instant;

use anyhow::{Context as _, Error, Result};
use clap::ValueEnum;
use clap::builder::RangedI64ValueParser;
use ga_mesh::atlas;
use ga_mesh::bake::OcclusionOptions;
use ga_render::bake::{MapKind, Maps, MapsError, MapsOptions, MeshColours};

use crate::frame::{Command, Context};
use crate::mesh_file;
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
#[derive(Clone, Copy, Debug, ValueEnum)]
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

impl From<Map> for MapKind {
    fn from(map: Map) -> Self {
        match map {
            Map::Normal => Self::Normal,
            Map::Displacement => Self::Displacement,
            Map::Colour => Self::Colour,
            Map::Occlusion => Self::Occlusion,
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

impl Command for Arguments {
    type Report = Report;

    fn run(&self, context: &Context) -> Result<Report> {
        let kinds: BTreeSet<MapKind> = self.maps.iter().copied().map(MapKind::from).collect();
        let mesh_files = Maps::MESH_FILES.map(str::to_owned);
        let names = kinds.iter().map(|kind| kind.file()).chain(mesh_files);
        let mut files = context.files([&self.fine, &self.coarse])?;
        files.write_folder("--out", &self.out, names)?;
        let begin = Instant::now();
        let progress = context.progress(kinds.len() as u64 + 6);
        let mut steps = Steps::new(&progress);

        steps.begin("read");
        let (fine, mut warnings) = mesh_file::read(&self.fine)?;
        let (coarse, of_coarse) = mesh_file::read(&self.coarse)?;
        let (colours, missing) = match kinds.contains(&MapKind::Colour) {
            true => {
                let found = MeshColours::new(&fine, self.fine.parent());
                let found = found.with_context(|| self.fine.display().to_string())?;
                (Some(found.0), found.1)
            }
            false => (None, Vec::new()),
        };
        let missing = missing.iter().map(ToString::to_string);
        for warning in mesh_file::missing_parts(&self.fine, missing) {
            // The reader of OBJ files says as well which pictures are missing.
            if !warnings.contains(&warning) {
                warnings.push(warning);
            }
        }
        warnings.extend(of_coarse);

        let options = self.options();
        let step = |name| steps.begin(name);
        let maps = Maps::bake(&fine, &coarse, colours.as_ref(), &kinds, &options, step);
        let maps = maps.map_err(|error| self.located(error))?;
        steps.begin("encode");
        let files = maps.files().map_err(|error| self.located(error))?;
        steps.begin("write");
        let names: Vec<String> = files.iter().map(|(name, _)| name.clone()).collect();
        let files = files.into_iter();
        let files = files.map(|(name, contents)| (self.out.join(name), contents));
        let files: Vec<(PathBuf, Vec<u8>)> = files.collect();
        mesh_file::check_parts("--out", &[&self.fine, &self.coarse], &files)?;
        context.outputs().write_all(&files)?;

        let seconds = steps.finish(begin);
        drop(progress);
        Ok(Report {
            folder: self.out.clone(),
            warnings,
            seconds,
            maps: maps.report,
            files: names,
        })
    }
}

impl Arguments {
    fn options(&self) -> MapsOptions {
        let mut occlusion = OcclusionOptions::default();
        occlusion.rays = self.rays;
        occlusion.seed = self.seed;
        occlusion.distance = self.occlusion_distance.unwrap_or(f64::INFINITY);
        MapsOptions {
            atlas: atlas::Options {
                size: self.size,
                margin_texels: self.margin,
                ..atlas::Options::default()
            },
            unwrap: self.unwrap,
            cage_distance: self.distance,
            occlusion,
        }
    }

    /// An error with the file of the mesh that it is about.
    fn located(&self, error: MapsError) -> Error {
        let file = if error.is_of_fine() {
            &self.fine
        } else {
            &self.coarse
        };
        Error::new(error).context(file.display().to_string())
    }
}
