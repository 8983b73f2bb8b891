//! Levels 0 to 3 of two subdivision surfaces side by side: above a cube whose lid has a sharp rim,
//! whose base has a half sharp one and which has a sharp corner, by Catmull and Clark's scheme;
//! below the mesh of a file by Loop's.
//!
//! `cargo run --release -p ga-render --example subdivision -- spot.obj subdivision.png`

use std::error::Error;

use ga_image::colour::LinearColour;
use ga_image::plane::Plane;
use ga_image::png;
use ga_mesh::subdivision::{Cage, Corner, Crease, INFINITELY_SHARP, Rules, Tags};
use ga_mesh::{Faces, Mesh, obj};
use ga_render::{Normals, Polyline, Scene, Style, View, ViewDirection, Visibility, render};

const SIZE: usize = 360;
const LEVELS: u32 = 4;

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = std::env::args().skip(1);
    let (Some(file), Some(out), None) = (arguments.next(), arguments.next(), arguments.next())
    else {
        return Err(
            "the arguments are a triangle mesh as OBJ and the picture to be written".into(),
        );
    };
    let mut sheet = Plane::filled(LEVELS as usize * SIZE, 2 * SIZE, [0; 3]);

    let (cube, tags) = cube()?;
    let view = |azimuth: f64, elevation: f64| ViewDirection {
        azimuth: azimuth.to_radians(),
        elevation: elevation.to_radians(),
    };
    let corners: Vec<_> = cube.coordinates().collect();
    let camera = View::fit(corners, view(28.0, 24.0), 0.5, 1.0, 0.08)?;
    row(&mut sheet, 0, &cube, Rules::CATMULL_CLARK, &tags, &camera)?;

    let mesh = obj::read(file)?;
    let mesh = Mesh::new(
        mesh.positions().to_vec(),
        Faces::from_uniform(mesh.triangles())?,
    )?;
    // The head: what lies in the upper half of the front.
    let [low, high] = mesh.bounds().ok_or("the mesh has no vertices")?;
    let is_head = |&[_, y, z]: &[f64; 3]| {
        y > 0.45 * low[1] + 0.55 * high[1] && z < 0.6 * low[2] + 0.4 * high[2]
    };
    let head: Vec<_> = mesh.coordinates().filter(is_head).collect();
    let camera = View::fit(head, view(205.0, 8.0), 0.5, 1.0, 0.3)?;
    row(&mut sheet, 1, &mesh, Rules::LOOP, &Tags::default(), &camera)?;

    png::write(out, &sheet)?;
    Ok(())
}

fn cube() -> Result<(Mesh, Tags), Box<dyn Error>> {
    let bit = |v: u32, axis: u32| f64::from(v >> axis & 1) * 2.0 - 1.0;
    let positions: Vec<_> = (0..8).map(|v| [bit(v, 0), bit(v, 1), bit(v, 2)]).collect();
    let faces = [
        [0, 2, 3, 1],
        [4, 5, 7, 6],
        [0, 1, 5, 4],
        [2, 6, 7, 3],
        [0, 4, 6, 2],
        [1, 3, 7, 5],
    ];
    let rim = |vertices: [u32; 4], sharpness: f64| {
        [0, 1, 2, 3].map(|at| Crease {
            vertices: [vertices[at], vertices[(at + 1) % 4]],
            sharpness,
        })
    };
    let tags = Tags {
        creases: [rim([2, 6, 7, 3], INFINITELY_SHARP), rim([0, 1, 5, 4], 1.5)].concat(),
        corners: vec![Corner {
            vertex: 5,
            sharpness: INFINITELY_SHARP,
        }],
    };
    Ok((
        Mesh::new(positions, Faces::from_uniform(faces.to_vec())?)?,
        tags,
    ))
}

fn row(
    sheet: &mut Plane<[u8; 3]>,
    row: u32,
    mesh: &Mesh,
    rules: Rules,
    tags: &Tags,
    camera: &View,
) -> Result<(), Box<dyn Error>> {
    let style = Style {
        width: SIZE as u32,
        height: SIZE as u32,
        supersampling: 4,
        depth_contrast: 1.0,
        ..Style::default()
    };
    let mut cage = Cage::new(mesh.faces().clone(), mesh.vertex_count(), rules)?.with_tags(tags)?;
    let mut positions: Vec<_> = mesh.coordinates().collect();
    for level in 0..LEVELS {
        if level > 0 {
            let fine = cage.refine()?;
            positions = fine.stencils.applied(&positions)?;
            cage = fine.cage;
        }
        let triangles = cage.faces().triangles(&positions);
        let edges = cage.edges().all().iter();
        let edges: Vec<_> = edges
            .map(|edge| edge.map(|v| positions[v as usize]))
            .collect();
        let lines = edges.iter().map(|ends| Polyline {
            points: ends,
            colour: LinearColour::from_srgb([70, 84, 104]),
            width: if row == 0 { 1.3 } else { 0.5 },
            visibility: Visibility::Hidden,
        });
        let lines: Vec<_> = lines
            .take(if edges.len() < 20_000 { edges.len() } else { 0 })
            .collect();
        let mut scene = Scene::new(&positions, &triangles);
        scene.objects[0].normals = Normals::Flat;
        scene.lines = &lines;
        let picture = render(&scene, camera, &style)?;
        sheet.view_mut().put(
            &picture.colour,
            [level as usize * SIZE, row as usize * SIZE],
        );
    }
    Ok(())
}
