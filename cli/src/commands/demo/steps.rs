//! The commands that find everything again from films and pictures, in their order, and what they
//! compute as geometry.

/// A command of the demonstration. Its paths are those below the folder of the results.
pub(super) struct Step {
    /// Its key in `report.json`.
    pub(super) name: &'static str,
    /// Its heading on the page.
    pub(super) title: &'static str,
    /// The section of the paper.
    pub(super) section: &'static str,
    /// What it computes, in blades.
    pub(super) formula: &'static str,
    /// The command, without the name of the program.
    pub(super) line: &'static str,
    /// About which part of the whole time it takes, in hundredths.
    pub(super) share: u64,
}

/// Steps of which others need the names.
pub(super) const CALIBRATION: &str = "calibration";
pub(super) const DISPARITIES: &str = "disparities";
pub(super) const EVALUATION: &str = "evaluation";
pub(super) const CONTOUR: &str = "contour";
pub(super) const DOTS: &str = "dots";
pub(super) const PEOPLE: &str = "people";
pub(super) const KEY_FRAMES: &str = "key_frames";
pub(super) const QUALITY: &str = "quality";
pub(super) const STATISTICS: &str = "statistics";
pub(super) const SKIN: &str = "skin";
pub(super) const SUBDIVISION: &str = "subdivision";
pub(super) const COMFORT: &str = "comfort";
pub(super) const ALIGNED: &str = "aligned_comfort";
pub(super) const TEXTURE: &str = "texture";
pub(super) const MAPS: &str = "maps";

/// All commands in their order.
pub(super) const STEPS: [Step; 19] = [
    Step {
        name: CALIBRATION,
        title: "Calibration",
        section: "§2.1.2",
        formula: "pixel = K (M P ~M): the motor M takes the board to the camera; least squares over \
                  all motors and both cameras",
        line: "stereo calibrate --board 9x6 --square 0.06 --left boards/left-*.png \
               --right boards/right-*.png --out rig.yml",
        share: 8,
    },
    Step {
        name: "rectification",
        title: "Rectification",
        section: "§2.1.2",
        formula: "R = exp(−½ θ I) for each camera, so that the images of a point are in one row",
        line: "stereo rectify stills/left.png stills/right.png --rig rig.yml --out rectified",
        share: 1,
    },
    Step {
        name: DISPARITIES,
        title: "Depth",
        section: "§2.1.2",
        formula: "Z = f B / (d + c_right − c_left)",
        line: "stereo match rectified/left.png rectified/right.png --auto-range \
               --out disparity.pfm --picture disparity.png",
        share: 2,
    },
    Step {
        name: EVALUATION,
        title: "Errors of depth",
        section: "§2.1.2",
        formula: "bad-2 = the part of pixels with |d − d_true| > 2",
        line: "stereo evaluate disparity.pfm truth/disparity.pfm --visible truth/visible.png \
               --picture errors.png",
        share: 1,
    },
    Step {
        name: "surface",
        title: "Surface",
        section: "§2.1.2, fig. 1",
        formula: "P is midway between the rays l = c ∧ d ∧ e∞ of both cameras",
        line: "stereo reconstruct stills/left.png stills/right.png --rig rig.yml --surface \
               --texture --step 2 --out surface.glb",
        share: 3,
    },
    Step {
        name: CONTOUR,
        title: "A contour in space",
        section: "§2.1.4",
        formula: "circle = p ∧ q ∧ r, of points where the rays of both borders meet",
        line: "contour stills/left.png stills/right.png --rig rig.yml --circle 212,134,70 \
               --right-circle 172,126,70 --fit circle --out contour.obj",
        share: 1,
    },
    Step {
        name: DOTS,
        title: "Joints by dots",
        section: "§2.1.1",
        formula: "p′ = M p ~M for the dots of each bone: the motors M of the pose that best agree \
                  with all dots",
        line: "body dots film/left.y4m film/right.y4m --views views.json --out joints.json",
        share: 30,
    },
    Step {
        name: PEOPLE,
        title: "The body",
        section: "§2.3.3, §3.3.1",
        formula: "joint = G_root … G_parent G_joint (P): one motor for each bone, fitted to all views \
                  and frames",
        line: "people film/left.y4m film/right.y4m --joints joints.json --views views.json --up y \
               --floor 0 --out person",
        share: 12,
    },
    Step {
        name: KEY_FRAMES,
        title: "Key frames",
        section: "§3.1, fig. 6",
        formula: "difference of red in the background; novelty = 1 − I(A; B) / I",
        line: "video keyframes film/left.y4m --out keys --contact-sheet keys.png --plot curves.svg",
        share: 3,
    },
    Step {
        name: STATISTICS,
        title: "Shots",
        section: "§3.1.1, table 1",
        formula: "the part of shots whose background does not move",
        line: "video statistics film/left.y4m film/right.y4m",
        share: 3,
    },
    Step {
        name: QUALITY,
        title: "Quality of the film",
        section: "§3.4.3, fig. 12",
        formula: "PSNR = 10 log₁₀ 255² / MSE, also with each block weighted by attention",
        line: "quality compare film/clean.y4m film/part.y4m --csv quality.csv --plot quality.svg",
        share: 4,
    },
    Step {
        name: COMFORT,
        title: "Comfort before",
        section: "§3.4.2",
        formula: "eleven scores from 0 to 15: green to 7, orange to 13, red above",
        line: "video comfort film/left.y4m film/right.y4m --layout two-files \
               --summary comfort.json --out comfort.html",
        share: 6,
    },
    Step {
        name: "alignment",
        title: "Alignment",
        section: "§3.4.2",
        formula: "x′ = T R D x ~(T R D): shift, roll and scale of the right view; its light as that \
                  of the left",
        line: "video align film/left.y4m film/right.y4m --out aligned.y4m \
               --shift-parallax recommended",
        share: 6,
    },
    Step {
        name: ALIGNED,
        title: "Comfort after",
        section: "§3.4.2, table 6",
        formula: "the same eleven scores",
        line: "video comfort aligned.y4m --layout side-by-side --summary aligned.json \
               --out aligned.html",
        share: 6,
    },
    Step {
        name: SKIN,
        title: "The skin of a moment",
        section: "§2.3.3",
        formula: "x′ = G x ~G with G = Σ wᵢ Gᵢ, normalised",
        line: "skin person/character.glb --animation 0 --time 0.48 --method motor --out posed.obj",
        share: 1,
    },
    Step {
        name: SUBDIVISION,
        title: "Subdivision",
        section: "§3.3.2, table 4",
        formula: "V → V + E vertices, F → 4 F faces",
        line: "mesh subdivide posed.obj --levels 1 --out fine.obj",
        share: 2,
    },
    Step {
        name: TEXTURE,
        title: "Texture from the views",
        section: "§2.1.3",
        formula: "an affine map of the corners of each triangle p ∧ q ∧ r ∧ e∞ to pixels of the \
                  views that see it",
        line: "texture posed.obj --views views.json --size 768 --out textured.glb",
        share: 4,
    },
    Step {
        name: MAPS,
        title: "Baked maps",
        section: "§3.3.2, table 5",
        formula: "the height of the fine surface along the normals of the coarse one",
        line: "mesh bake --fine fine.obj --coarse posed.obj --maps normal,displacement \
               --size 1024 --out baked",
        share: 5,
    },
    Step {
        name: "operations",
        title: "What a motor costs",
        section: "§2.3.1, §2.3.2",
        formula: "M P ~M, of a motor with 8 numbers and a conformal point with 3",
        line: "expand --expr 'fn moved(m: Motor, p: Point) -> Point { m * p * rev(m) }' --emit ops",
        share: 1,
    },
];
