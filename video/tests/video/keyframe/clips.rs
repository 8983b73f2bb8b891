//! Clips made of random scenes, with the frames at which their shots begin.

use std::ops::Range;

use ga_image::plane::Plane;

/// Columns and rows of the clips.
pub(crate) const SIZE: [usize; 2] = [160, 90];

/// What is done to a clip after it was made; its labels remain.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Effect {
    None,
    Letterbox,
    Pillarbox,
    Captions,
    /// A box with a caption that stands over all shots.
    Banner,
    /// The brightness of each frame differs by up to 20 %.
    Flicker,
    /// White or bright single frames.
    Flashes,
    Noise,
    /// A quarter of the brightness.
    Dark,
    HalfRate,
}

impl Effect {
    pub(crate) const ALL: [Self; 10] = [
        Self::None,
        Self::Letterbox,
        Self::Pillarbox,
        Self::Captions,
        Self::Banner,
        Self::Flicker,
        Self::Flashes,
        Self::Noise,
        Self::Dark,
        Self::HalfRate,
    ];
}

/// Which transitions a clip has.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Joins {
    Cuts,
    Dissolves,
    Fades,
}

/// A clip as red, which is luma without colour differences.
pub(crate) struct Clip {
    pub(crate) frames: Vec<Plane<u8>>,
    pub(crate) labels: Labels,
}

/// The transitions of a clip.
#[derive(Clone, Debug, Default)]
pub(crate) struct Labels {
    pub(crate) cuts: Vec<usize>,
    pub(crate) dissolves: Vec<Range<usize>>,
    pub(crate) fades: Vec<Range<usize>>,
}

/// Reproducible random numbers (splitmix64).
#[derive(Clone)]
pub(crate) struct Random(u64);

impl Random {
    pub(crate) fn new(seed: u64) -> Self {
        Self(seed.wrapping_mul(0x9E37_79B9_7F4A_7C15) ^ 0xD1B5_4A32_D192_ED03)
    }

    fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        mixed(self.0)
    }

    pub(crate) fn between(&mut self, low: f32, high: f32) -> f32 {
        low + (high - low) * (self.bits() >> 40) as f32 / (1u64 << 24) as f32
    }

    pub(crate) fn index(&mut self, range: Range<usize>) -> usize {
        range.start + (self.bits() % range.len() as u64) as usize
    }
}

fn mixed(mut z: u64) -> u64 {
    z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
    z ^ (z >> 31)
}

/// Noise of three octaves, from −1 to 1, over the whole plane.
struct Texture {
    seed: u64,
    /// Pixels from one number of the coarsest octave to the next.
    grain: f32,
    rough: f32,
}

impl Texture {
    fn at(&self, x: f32, y: f32) -> f32 {
        let (mut sum, mut weight, mut total) = (0.0, 1.0, 0.0);
        for octave in 0..3 {
            let scale = (1 << octave) as f32 / self.grain;
            sum += weight * self.lattice(x * scale, y * scale, octave);
            total += weight;
            weight *= self.rough;
        }
        sum / total
    }

    fn lattice(&self, x: f32, y: f32, octave: u64) -> f32 {
        let (column, row) = (x.floor(), y.floor());
        let smooth = |t: f32| t * t * (3.0 - 2.0 * t);
        let (fx, fy) = (smooth(x - column), smooth(y - row));
        let value = |i: i64, j: i64| {
            let place = (column as i64 + i) as u64 ^ ((row as i64 + j) as u64).rotate_left(32);
            let bits = mixed(mixed(place ^ self.seed) ^ (octave + 1));
            (bits >> 40) as f32 / (1u64 << 23) as f32 - 1.0
        };
        let mix = |a: f32, b: f32, t: f32| a + t * (b - a);
        let above = mix(value(0, 0), value(1, 0), fx);
        mix(above, mix(value(0, 1), value(1, 1), fx), fy)
    }
}

struct Object {
    texture: Texture,
    level: f32,
    place: [f32; 2],
    velocity: [f32; 2],
    radius: [f32; 2],
}

/// A background under a moving camera, with objects before it.
struct Scene {
    texture: Texture,
    level: f32,
    contrast: f32,
    /// From top to bottom, as between sky and ground.
    gradient: f32,
    pan: [f32; 2],
    zoom: f32,
    objects: Vec<Object>,
}

impl Scene {
    fn new(random: &mut Random) -> Self {
        let texture = |random: &mut Random| Texture {
            seed: random.bits(),
            grain: random.between(10.0, 60.0),
            rough: random.between(0.3, 0.8),
        };
        let moving = random.between(0.0, 1.0) < 0.6;
        let speed = if moving {
            random.between(0.2, 4.0)
        } else {
            0.0
        };
        let angle = random.between(0.0, std::f32::consts::TAU);
        let objects = (0..random.index(0..4)).map(|_| Object {
            texture: texture(random),
            level: random.between(40.0, 220.0),
            place: [random.between(0.0, 160.0), random.between(20.0, 90.0)],
            velocity: [random.between(-6.0, 6.0), random.between(-2.0, 2.0)],
            radius: [random.between(6.0, 26.0), random.between(8.0, 26.0)],
        });
        let objects = objects.collect();
        Self {
            texture: texture(random),
            level: random.between(70.0, 180.0),
            contrast: random.between(30.0, 90.0),
            gradient: random.between(-40.0, 40.0),
            pan: [speed * angle.cos(), 0.5 * speed * angle.sin()],
            zoom: if moving {
                random.between(-0.004, 0.004)
            } else {
                0.0
            },
            objects,
        }
    }

    fn frame(&self, time: f32) -> Plane<f32> {
        let scale = 1.0 + self.zoom * time;
        Plane::from_fn(SIZE[0], SIZE[1], |column, row| {
            let (x, y) = (column as f32, row as f32);
            for object in &self.objects {
                let [dx, dy] = [0, 1].map(|axis| {
                    let at = object.place[axis] + time * object.velocity[axis];
                    // Objects return at the other side.
                    let room = SIZE[axis] as f32 + 60.0;
                    [x, y][axis] - ((at + 30.0).rem_euclid(room) - 30.0)
                });
                if (dx / object.radius[0]).hypot(dy / object.radius[1]) < 1.0 {
                    return object.level + 30.0 * object.texture.at(dx, dy);
                }
            }
            let u = (x - 80.0) * scale + self.pan[0] * time;
            let v = (y - 45.0) * scale + self.pan[1] * time;
            let sky = self.gradient * (y / 45.0 - 1.0);
            self.level + sky + self.contrast * self.texture.at(u, v)
        })
    }
}

/// A clip before an effect: its frames, its labels, and the state of the random numbers after it.
pub(crate) struct Base {
    pub(crate) frames: Vec<Plane<f32>>,
    pub(crate) labels: Labels,
    pub(crate) random: Random,
}

/// A clip with some shots, all of whose transitions are of one kind.
pub(crate) fn clip(seed: u64, joins: Joins, effect: Effect) -> Clip {
    base(seed, joins).with(effect)
}

/// The same before the effect.
pub(crate) fn base(seed: u64, joins: Joins) -> Base {
    let mut random = Random::new(seed);
    let shots = random.index(2..6);
    let mut frames: Vec<Plane<f32>> = Vec::new();
    let (mut cuts, mut dissolves, mut fades) = (Vec::new(), Vec::new(), Vec::new());
    let mut scene = Scene::new(&mut random);
    let mut time = 0.0;
    for shot in 0..shots {
        for _ in 0..random.index(14..50) {
            frames.push(scene.frame(time));
            time += 1.0;
        }
        if shot + 1 == shots {
            break;
        }
        let next = Scene::new(&mut random);
        let start = frames.len();
        match joins {
            Joins::Cuts => {
                cuts.push(start);
                time = 0.0;
            }
            Joins::Dissolves => {
                let length = random.index(8..25);
                for step in 0..length {
                    let part = (step + 1) as f32 / (length + 1) as f32;
                    let (a, b) = (scene.frame(time + step as f32), next.frame(step as f32));
                    frames.push(blended(&a, &b, part));
                }
                dissolves.push(start..frames.len());
                time = length as f32;
            }
            Joins::Fades => {
                let flat = Plane::filled(SIZE[0], SIZE[1], [0.0, 255.0][random.index(0..2)]);
                let [out, gap, back] = [8..25, 2..7, 8..25].map(|range| random.index(range));
                for step in 0..out {
                    let part = (step + 1) as f32 / (out + 1) as f32;
                    frames.push(blended(&scene.frame(time + step as f32), &flat, part));
                }
                fades.push(start..frames.len());
                frames.extend(std::iter::repeat_n(flat.clone(), gap));
                let start = frames.len();
                for step in 0..back {
                    let part = (step + 1) as f32 / (back + 1) as f32;
                    frames.push(blended(&flat, &next.frame(step as f32), part));
                }
                fades.push(start..frames.len());
                time = back as f32;
            }
        }
        scene = next;
    }
    let labels = Labels {
        cuts,
        dissolves,
        fades,
    };
    Base {
        frames,
        labels,
        random,
    }
}

pub(crate) fn blended(a: &Plane<f32>, b: &Plane<f32>, part: f32) -> Plane<f32> {
    let pairs = a.values().iter().zip(b.values());
    let values = pairs.map(|(a, b)| a + part * (b - a)).collect();
    Plane::from_values(SIZE[0], SIZE[1], values).unwrap()
}

impl Base {
    /// The clip with an effect.
    pub(crate) fn with(&self, effect: Effect) -> Clip {
        affected(&self.frames, &self.labels, effect, &mut self.random.clone())
    }
}

fn affected(frames: &[Plane<f32>], labels: &Labels, effect: Effect, random: &mut Random) -> Clip {
    let near_cut = |frame: usize| labels.cuts.iter().any(|cut| cut.abs_diff(frame) < 6);
    let mut caption = (0, 0, 0);
    let finished = frames.iter().enumerate().map(|(index, frame)| {
        if index >= caption.1 {
            let start = index + random.index(0..20);
            caption = (start, start + random.index(15..60), random.index(1..1000));
        }
        let shown = (caption.0..caption.1).contains(&index);
        let gain = random.between(0.8, 1.2);
        let flash = effect == Effect::Flashes && index % 23 == 11 && !near_cut(index);
        let white = index % 2 == 1;
        Plane::from_fn(SIZE[0], SIZE[1], |column, row| {
            let value = frame.get(column, row).unwrap();
            let noise = random.between(-1.0, 1.0) + random.between(-1.0, 1.0);
            let value = match effect {
                Effect::Letterbox if !(11..79).contains(&row) => 0.0,
                Effect::Pillarbox if !(20..140).contains(&column) => 0.0,
                Effect::Captions if shown && (72..84).contains(&row) => {
                    let letter = mixed((column / 4 * 31 + row / 4 + caption.2 * 997) as u64) % 2;
                    let inside = (30..130).contains(&column) && letter == 0;
                    if inside { 240.0 } else { value }
                }
                Effect::Banner if row >= 74 => {
                    let letter = mixed((column / 5 * 37 + row / 5) as u64).is_multiple_of(6);
                    if letter { 220.0 } else { 30.0 }
                }
                Effect::Flicker => value * gain,
                Effect::Flashes if flash && white => 255.0,
                Effect::Flashes if flash => 1.7 * value + 40.0,
                Effect::Noise => value + 10.0 * noise,
                Effect::Dark => 0.25 * value,
                _ => value,
            };
            // A cast from float saturates.
            (value + 0.5) as u8
        })
    });
    let finished: Vec<Plane<u8>> = finished.collect();
    if effect != Effect::HalfRate {
        return Clip {
            frames: finished,
            labels: labels.clone(),
        };
    }
    let half = |range: &Range<usize>| range.start.div_ceil(2)..range.end.div_ceil(2);
    Clip {
        frames: finished.into_iter().step_by(2).collect(),
        labels: Labels {
            cuts: labels.cuts.iter().map(|cut| cut.div_ceil(2)).collect(),
            dissolves: labels.dissolves.iter().map(half).collect(),
            fades: labels.fades.iter().map(half).collect(),
        },
    }
}
