//! Bakes the bumps of a fine torus into maps for a smooth coarse one, and draws both side by side.
//!
//! `cargo run --release -p ga-render --example baked_maps -- FOLDER [MESH.obj]` writes
//! `baked_beside_fine.png`, `baked_maps.png` and `atlas_charts.png`, the last one of the given
//! mesh, and prints the figures.

use std::env;
use std::error::Error;
use std::f64::consts::TAU;
use std::path::Path;
use std::time::Instant;

use ga_image::colour::{LinearColour, SrgbEncoder};
use ga_image::plane::Plane;
use ga_image::png;
use ga_image::quality::Ssim;
use ga_mesh::atlas::{self, Atlas};
use ga_mesh::bake::{Bake, Coarse, Fine, Map, OcclusionOptions, Options, corner_colours};
use ga_mesh::normals::vertex_normals;
use ga_mesh::subdivision::{Cage, Rules};
use ga_mesh::{CornerAttribute, Faces, Mesh, obj, tangents};
use ga_render::texture::{Filter, Mipmap, Sampler, Wrap};
use ga_render::{
    Appearance, Attribute, MaterialChoice, Object, Scene, Style, View, ViewDirection, render,
};

type Picture = Plane<[u8; 3]>;

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = env::args().skip(1);
    let folder = arguments
        .next()
        .ok_or("usage: baked_maps FOLDER [MESH.obj]")?;
    let folder = Path::new(&folder);
    let (coarse, fine) = surfaces()?;

    let begin = Instant::now();
    let positions: Vec<[f64; 3]> = coarse.coordinates().collect();
    let triangles = coarse.triangles();
    let atlas = atlas::unwrap(&positions, &triangles, &atlas::Options::default())?;
    let atlas_time = begin.elapsed();
    let coarse = coarse.with_texture_coordinates(vec![atlas.texture_coordinates()])?;
    let coarse = with_tangents(coarse)?;

    let begin = Instant::now();
    let detail = Fine::from_mesh(&fine)?;
    let hierarchy_time = begin.elapsed();
    let begin = Instant::now();
    let surface = Coarse::from_mesh(&coarse, 0)?;
    let bake = Bake::new(&surface, &detail, &Options::default())?;
    let normals = bake.normals();
    let heights = bake.displacement();
    let corners = corner_colours(&fine).ok_or("the fine torus has no colours")?;
    let colours = bake.colour(|point| {
        let [r, g, b, _] = point.mean(&corners[point.triangle as usize]);
        [r, g, b].map(|x| x as f32)
    });
    let bake_time = begin.elapsed();
    let begin = Instant::now();
    let bake = Bake::new(&surface, &detail, &Options::with_size(512))?;
    let occlusion = bake.occlusion(&OcclusionOptions::default())?;
    let occlusion_time = begin.elapsed();

    let report = atlas.report;
    println!(
        "faces, fine and coarse    {} {}",
        fine.faces().len(),
        triangles.len()
    );
    println!("charts                    {}", report.charts);
    println!("utilisation               {:.3}", report.utilisation);
    println!("L2 stretch                {:.4}", report.stretch_l2);
    println!("flipped triangles         {}", report.flipped);
    println!("overlapping texels        {}", report.overlapping_texels);
    println!("atlas                     {atlas_time:.1?}");
    println!("hierarchy                 {hierarchy_time:.1?}");
    println!("three maps, 1024²         {bake_time:.1?}");
    println!("occlusion, 512², 32 rays  {occlusion_time:.1?}");

    let shown = Shown::new(&coarse, &normals, &colours)?;
    let pictures = [
        picture_of_fine(&fine)?,
        shown.picture(true)?,
        shown.picture(false)?,
    ];
    let ssim = Ssim::new(255.0);
    let with_maps = ssim.compare(&pictures[0], &pictures[1])?.ssim;
    let without = ssim.compare(&pictures[0], &pictures[2])?.ssim;
    println!("SSIM of the coarse torus with its maps and the fine one  {with_maps:.4}");
    println!("SSIM without the normal map                              {without:.4}");
    png::write(folder.join("baked_beside_fine.png"), &beside(&pictures))?;

    let maps = [
        picture_of(&normals, |n| n.map(|x| (127.5 * (x + 1.0)).round() as u8)),
        picture_of_heights(&heights),
        picture_of(&colours, encoded),
        picture_of(&occlusion, |[share]| [(255.0 * share).round() as u8; 3]),
    ];
    let reduced = maps.map(|map| shrunk(map, 512));
    png::write(folder.join("baked_maps.png"), &beside(&reduced))?;

    let (positions, triangles) = match arguments.next() {
        Some(file) => {
            let mesh = read(&file)?;
            (mesh.coordinates().collect(), mesh.triangles())
        }
        None => (positions, triangles),
    };
    let atlas = atlas::unwrap(&positions, &triangles, &atlas::Options::default())?;
    let charts = [
        picture_of_charts(&positions, &triangles, &atlas)?,
        picture_of_atlas(&atlas, 720)?,
    ];
    png::write(folder.join("atlas_charts.png"), &beside(&charts))?;
    Ok(())
}

fn read(file: &str) -> Result<Mesh, Box<dyn Error>> {
    Ok(obj::decode(&std::fs::read(file)?)?)
}

/// A torus of 13,824 triangles, and its refinement with bumps and colours.
fn surfaces() -> Result<(Mesh, Mesh), Box<dyn Error>> {
    const AROUND: u32 = 96;
    const ACROSS: u32 = 72;
    let mut positions = Vec::new();
    let mut triangles = Vec::new();
    for i in 0..AROUND {
        for j in 0..ACROSS {
            let a = TAU * f64::from(i) / f64::from(AROUND);
            let b = TAU * f64::from(j) / f64::from(ACROSS);
            let r = 1.0 + 0.4 * b.cos();
            positions.push([r * a.cos(), 0.4 * b.sin(), -r * a.sin()]);
            let at = |i: u32, j: u32| (i % AROUND) * ACROSS + j % ACROSS;
            let [p, q] = [at(i, j), at(i + 1, j)];
            let [s, t] = [at(i, j + 1), at(i + 1, j + 1)];
            triangles.extend([[p, q, t], [p, t, s]]);
        }
    }
    let faces = Faces::from_polygons(&triangles)?;
    let refined = Cage::new(faces.clone(), positions.len(), Rules::LOOP)?.refine()?;
    let smooth: Vec<[f64; 3]> = refined.stencils.applied(&positions)?;
    let fine_faces = refined.cage.faces().clone();
    let normals = vertex_normals(&smooth, &fine_faces.triangles(&smooth));
    let mut bumpy = Vec::new();
    let mut colours = Vec::new();
    for (&[x, y, z], normal) in smooth.iter().zip(normals) {
        let a = z.atan2(x);
        let b = y.atan2(x.hypot(z) - 1.0);
        let bump = (18.0 * a).sin() * (9.0 * b).sin();
        let height = 0.02 * bump + 0.012 * (7.0 * a + 3.0 * b).sin();
        bumpy.push([0, 1, 2].map(|k| [x, y, z][k] + height * normal[k]));
        let share = 0.5 + 0.5 * (7.0 * a + 3.0 * b).sin();
        let warm = LinearColour::from_srgb([226, 122, 63]);
        let cold = LinearColour::from_srgb([47, 110, 143]);
        let [red, green, blue] = cold.lerp(warm, share).channels();
        colours.push([red, green, blue, 1.0]);
    }
    let fine = Mesh::new(bumpy, fine_faces)?.with_colours(colours)?;
    Ok((Mesh::new(positions, faces)?, fine))
}

/// The mesh with smooth normals and the tangents for normal maps.
fn with_tangents(mesh: Mesh) -> Result<Mesh, Box<dyn Error>> {
    let positions: Vec<[f64; 3]> = mesh.coordinates().collect();
    let normals = vertex_normals(&positions, &mesh.triangles());
    let normals = normals.into_iter().map(Into::into).collect();
    let normals = CornerAttribute::of_vertices(normals, mesh.faces());
    let mesh = mesh.with_normals(normals)?;
    let tangents = tangents::mikktspace(&mesh, 0)?;
    Ok(mesh.with_tangents(tangents)?)
}

/// The coarse mesh with its maps, as the renderer takes it.
struct Shown {
    positions: Vec<[f64; 3]>,
    triangles: Vec<[u32; 3]>,
    places: Vec<[f64; 2]>,
    of_places: Vec<Option<[u32; 3]>>,
    tangents: Vec<[f64; 4]>,
    of_tangents: Vec<Option<[u32; 3]>>,
    normal_map: Mipmap,
    colour_map: Mipmap,
}

impl Shown {
    fn new(mesh: &Mesh, normals: &Map<3>, colours: &Map<3>) -> Result<Self, Box<dyn Error>> {
        let places = mesh.texture_coordinates().ok_or("no texture coordinates")?;
        let tangents = mesh.tangents().ok_or("no tangents")?;
        let direction = |tangent: &ga_mesh::Tangent| {
            let [x, y, z] = tangent.direction.coordinates();
            [x, y, z, tangent.handedness]
        };
        Ok(Self {
            positions: mesh.coordinates().collect(),
            triangles: mesh.triangles(),
            places: places.values.clone(),
            of_places: threes(&places.corners),
            tangents: tangents.values.iter().map(direction).collect(),
            of_tangents: threes(&tangents.corners),
            normal_map: texture(normals, |x| 0.5 * (x + 1.0))?,
            colour_map: texture(colours, |x| x)?,
        })
    }

    fn picture(&self, with_normals: bool) -> Result<Picture, Box<dyn Error>> {
        let material = Appearance {
            base_colour_map: Some(&self.colour_map),
            normal_map: with_normals.then_some(&self.normal_map),
            ..surface()
        };
        let object = Object {
            texture_coordinates: Some(Attribute::of_corners(&self.places, &self.of_places)),
            tangents: Some(Attribute::of_corners(&self.tangents, &self.of_tangents)),
            material: MaterialChoice::One(0),
            ..Object::new(&self.positions, &self.triangles)
        };
        picture(object, &[material], torus_view())
    }
}

/// For each triangle the indices at its corners.
fn threes(corners: &[Option<u32>]) -> Vec<Option<[u32; 3]>> {
    let triangles = corners.as_chunks::<3>().0.iter();
    triangles.map(|&[a, b, c]| Some([a?, b?, c?])).collect()
}

fn texture(map: &Map<3>, share: impl Fn(f64) -> f64) -> Result<Mipmap, Box<dyn Error>> {
    let pixel = |texel: &[f32; 3]| {
        let [r, g, b] = texel.map(|x| share(f64::from(x)));
        [r, g, b, 1.0]
    };
    let pixels: Vec<[f64; 4]> = map.texels.iter().map(pixel).collect();
    let sampler = Sampler {
        wrap: [Wrap::Repeat; 2],
        filter: Filter::Bilinear,
    };
    Ok(Mipmap::numbers(
        map.width as usize,
        map.height as usize,
        &pixels,
        sampler,
    )?)
}

fn surface() -> Appearance<'static> {
    Appearance {
        roughness: 0.55,
        ..Appearance::default()
    }
}

fn torus_view() -> ViewDirection {
    ViewDirection {
        azimuth: 0.5,
        elevation: 0.75,
    }
}

fn picture_of_fine(mesh: &Mesh) -> Result<Picture, Box<dyn Error>> {
    let positions: Vec<[f64; 3]> = mesh.coordinates().collect();
    let triangles = mesh.triangles();
    let object = Object {
        colours: mesh.colours().map(Attribute::of_vertices),
        material: MaterialChoice::One(0),
        ..Object::new(&positions, &triangles)
    };
    picture(object, &[surface()], torus_view())
}

fn picture(
    object: Object,
    materials: &[Appearance],
    view: ViewDirection,
) -> Result<Picture, Box<dyn Error>> {
    let style = Style {
        width: 720,
        height: 720,
        supersampling: 3,
        ..Style::default()
    };
    // The same camera for the fine and the coarse surface.
    let points: Vec<[f64; 3]> = match view == torus_view() {
        true => (0..128)
            .map(|step| {
                let (sine, cosine) = (TAU * f64::from(step / 2) / 64.0).sin_cos();
                [1.44 * cosine, [-0.3, 0.3][step as usize % 2], 1.44 * sine]
            })
            .collect(),
        false => object.positions.to_vec(),
    };
    let camera = View::fit(points, view, 0.5, style.aspect(), 0.06)?;
    let scene = Scene {
        objects: vec![object],
        materials,
        ..Scene::default()
    };
    Ok(render(&scene, &camera, &style)?.colour)
}

/// The mesh with a colour for each chart.
fn picture_of_charts(
    positions: &[[f64; 3]],
    triangles: &[[u32; 3]],
    atlas: &Atlas,
) -> Result<Picture, Box<dyn Error>> {
    let materials: Vec<Appearance> = (0..atlas.report.charts as u32)
        .map(|chart| Appearance {
            base_colour: LinearColour::from_srgb(colour(chart)),
            ..surface()
        })
        .collect();
    let of_triangles: Vec<Option<u32>> = atlas.charts.iter().copied().map(Some).collect();
    let object = Object {
        material: MaterialChoice::PerTriangle(&of_triangles),
        ..Object::new(positions, triangles)
    };
    let view = ViewDirection {
        azimuth: 3.7,
        elevation: 0.2,
    };
    picture(object, &materials, view)
}

/// The texture with a colour for each chart and the edges of the triangles.
fn picture_of_atlas(atlas: &Atlas, size: usize) -> Result<Picture, Box<dyn Error>> {
    // Three samples along each side of a pixel.
    let side = 3 * size;
    let mut fine = Plane::filled(side, side, [236_u8, 238, 242]);
    for (corners, &chart) in atlas.coordinates.iter().zip(&atlas.charts) {
        let place = corners.map(|[u, v]| [u * side as f64, (1.0 - v) * side as f64]);
        let [a, b, c] = place;
        let range = |axis: usize| {
            let low = a[axis].min(b[axis]).min(c[axis]).max(0.0) as usize;
            let high = a[axis].max(b[axis]).max(c[axis]).ceil() as usize;
            low..high.min(side)
        };
        let area = |p: [f64; 2], q: [f64; 2], r: [f64; 2]| {
            (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])
        };
        for row in range(1) {
            for column in range(0) {
                let p = [column as f64 + 0.5, row as f64 + 0.5];
                // The rows run down, so that the orientation is the other one.
                let distance = |q: [f64; 2], r: [f64; 2]| {
                    area(q, p, r) / (r[0] - q[0]).hypot(r[1] - q[1]).max(1e-9)
                };
                let inside = distance(a, b).min(distance(b, c)).min(distance(c, a));
                if inside >= 0.0 {
                    let shade = if inside < 0.8 { 0.72 } else { 1.0 };
                    let pixel = colour(chart).map(|code| (f64::from(code) * shade) as u8);
                    fine.row_mut(row)[column] = pixel;
                }
            }
        }
    }
    Ok(shrunk(fine, size))
}

/// Colours that differ from one number to the next.
fn colour(chart: u32) -> [u8; 3] {
    let hue = (f64::from(chart) * 0.618_033_988_75).fract() * 6.0;
    let value = [0.86, 0.72, 0.95][chart as usize % 3];
    [5.0, 3.0, 1.0].map(|offset: f64| {
        let k = (offset + hue) % 6.0;
        let part = k.min(4.0 - k).clamp(0.0, 1.0);
        (255.0 * value * (1.0 - 0.55 * part)) as u8
    })
}

fn picture_of<const C: usize>(map: &Map<C>, pixel: impl Fn([f32; C]) -> [u8; 3]) -> Picture {
    let width = map.width as usize;
    Plane::from_fn(width, map.height as usize, |column, row| {
        pixel(map.texels[row * width + column])
    })
}

fn picture_of_heights(map: &Map<1>) -> Picture {
    let largest = map
        .texels
        .iter()
        .fold(f32::MIN_POSITIVE, |most, [h]| most.max(h.abs()));
    picture_of(map, |[h]| [(127.5 * (1.0 + h / largest)).round() as u8; 3])
}

fn encoded(colour: [f32; 3]) -> [u8; 3] {
    thread_local!(static ENCODER: SrgbEncoder = SrgbEncoder::new());
    ENCODER.with(|encoder| encoder.encode(LinearColour::from(colour.map(f64::from))))
}

/// The means of squares of pixels, so that the picture gets this size.
fn shrunk(picture: Picture, size: usize) -> Picture {
    let step = (picture.width() / size).max(1);
    Plane::from_fn(size, size, |column, row| {
        let mut sums = [0_usize; 3];
        for y in row * step..(row + 1) * step {
            for pixel in &picture.row(y)[column * step..(column + 1) * step] {
                for (sum, code) in sums.iter_mut().zip(pixel) {
                    *sum += usize::from(*code);
                }
            }
        }
        sums.map(|sum| (sum / (step * step)) as u8)
    })
}

/// Pictures of the same height in a row.
fn beside(pictures: &[Picture]) -> Picture {
    const GAP: usize = 8;
    let width = pictures.iter().map(|p| p.width() + GAP).sum::<usize>() - GAP;
    let height = pictures.iter().map(Plane::height).max().unwrap_or(0);
    let mut row_of_pictures = Plane::filled(width, height, [255; 3]);
    let mut left = 0;
    for picture in pictures {
        for (row, pixels) in picture.rows().enumerate() {
            row_of_pictures.row_mut(row)[left..left + pixels.len()].copy_from_slice(pixels);
        }
        left += picture.width() + GAP;
    }
    row_of_pictures
}
