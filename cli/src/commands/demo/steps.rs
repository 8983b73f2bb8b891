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
    /// What it does, in plain words.
    pub(super) does: &'static str,
    /// What it computes, in blades.
    pub(super) formula: &'static str,
    /// The command, without the name of the program.
    pub(super) line: &'static str,
    /// What it writes, but for what other steps write anew.
    pub(super) files: &'static [&'static str],
    /// About which part of the whole time it takes, in hundredths.
    pub(super) share: u64,
}

/// Steps of which others need the names.
pub(super) const CALIBRATION: &str = "calibration";
pub(super) const DISPARITIES: &str = "disparities";
pub(super) const EVALUATION: &str = "evaluation";
pub(super) const SURFACE: &str = "surface";
pub(super) const SURFACE_VIEW: &str = "view_of_the_surface";
pub(super) const TEXTURED_VIEW: &str = "view_of_the_texture";
pub(super) const DOTS: &str = "dots";
pub(super) const RECTIFICATION: &str = "rectification";
pub(super) const ALIGNMENT: &str = "alignment";
pub(super) const OPERATIONS: &str = "operations";
pub(super) const CONTOUR: &str = "contour";
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
pub(super) const STEPS: [Step; 21] = [
    Step {
        name: CALIBRATION,
        title: "Calibration",
        section: "§2.1.2",
        does: "Ten pairs of pictures of a chessboard tell the focal lengths, the distortion, and \
               how the right camera stands to the left one.",
        formula: "pixel = K (M P ~M): the motor M takes the board to the camera; least squares over \
                  all motors and both cameras",
        line: "stereo calibrate --board 9x6 --square 0.06 --left boards/left-*.png \
               --right boards/right-*.png --out rig.yml",
        files: &["rig.yml"],
        share: 8,
    },
    Step {
        name: RECTIFICATION,
        title: "Rectification",
        section: "§2.1.2",
        does: "Both pictures are rotated so that the images of each point lie in one row, \
               whatever the roll of the right camera.",
        formula: "R = exp(−½ θ I) for each camera, so that the images of a point are in one row",
        line: "stereo rectify stills/left.png stills/right.png --rig rig.yml --out rectified",
        files: &["rectified/left.png", "rectified/right.png"],
        share: 1,
    },
    Step {
        name: DISPARITIES,
        title: "Depth",
        section: "§2.1.2",
        does: "For each pixel of the left picture its counterpart in the right one is searched; \
               how far it is shifted, the disparity, tells the depth.",
        formula: "Z = f B / (d + c_right − c_left)",
        line: "stereo match rectified/left.png rectified/right.png --auto-range \
               --out disparity.pfm --picture disparity.png",
        files: &["disparity.pfm", "disparity.png"],
        share: 2,
    },
    Step {
        name: EVALUATION,
        title: "Errors of depth",
        section: "§2.1.2",
        does: "The disparities are compared with those that the model of the room has: the share \
               of pixels that are wrong by more than 2.",
        formula: "bad-2 = the part of pixels with |d − d_true| > 2",
        line: "stereo evaluate disparity.pfm truth/disparity.pfm --visible truth/visible.png \
               --picture errors.png",
        files: &["errors.png"],
        share: 1,
    },
    Step {
        name: SURFACE,
        title: "Surface",
        section: "§2.1.2, fig. 1",
        does: "Each pair of pixels is a pair of rays, which meet in a point; neighbouring points \
               are joined to triangles with the colours of the picture.",
        formula: "P is midway between the rays l = c ∧ d ∧ e∞ of both cameras",
        line: "stereo reconstruct stills/left.png stills/right.png --rig rig.yml --surface \
               --texture --step 2 --out surface.glb",
        files: &["surface.glb"],
        share: 3,
    },
    Step {
        name: SURFACE_VIEW,
        title: "The surface from aside",
        section: "§2.1.2, fig. 1",
        does: "The surface as a camera sees it that stands to the right of both: what is white was \
               hidden from them.",
        formula: "pixel = K (M P ~M), of the points of all triangles",
        line: "render surface.glb --camera 'eye 0.7,0.5,0.9 target -0.1,0,-3.5 fov 40' \
               --shading unlit --size 960x640 --out surface.png",
        files: &["surface.png"],
        share: 1,
    },
    Step {
        name: CONTOUR,
        title: "A contour in space",
        section: "§2.1.4",
        does: "A snake closes around the disc on the wall in both pictures; where the rays of \
               both outlines meet is a curve in space, to which a circle is fitted.",
        formula: "circle = p ∧ q ∧ r, of points where the rays of both borders meet",
        line: "contour stills/left.png stills/right.png --rig rig.yml --fit circle \
               --out contour.obj",
        files: &["contour.obj"],
        share: 1,
    },
    Step {
        name: DOTS,
        title: "Joints by dots",
        section: "§2.1.1",
        does: "Coloured dots are found in each picture and recognised by their neighbours; the \
               pose that agrees best with all of them gives the joints in both pictures.",
        formula: "p′ = M p ~M for the dots of each bone: the motors M of the pose that best agree \
                  with all dots",
        line: "body dots film/left.y4m film/right.y4m --views views.json --out joints.json",
        files: &["joints.json"],
        share: 30,
    },
    Step {
        name: PEOPLE,
        title: "The body",
        section: "§2.3.3, §3.3.1",
        does: "A body with bones of constant length is fitted to the joints of all views and \
               frames at once: one motor for each bone and frame.",
        formula: "joint = G_root … G_parent G_joint (P): one motor for each bone, fitted to all views \
                  and frames",
        line: "people film/left.y4m film/right.y4m --joints joints.json --views views.json --up y \
               --floor 0 --out person",
        files: &[
            "person/character.glb",
            "person/motion.bvh",
            "person/joints.csv",
            "person/report.html",
        ],
        share: 12,
    },
    Step {
        name: KEY_FRAMES,
        title: "Key frames",
        section: "§3.1, fig. 6",
        does: "The frames that show most of the action: the first of each shot, and those after \
               which the contents have changed most.",
        formula: "difference of red in the background; novelty = 1 − I(A; B) / I",
        line: "video keyframes film/left.y4m --out keys --contact-sheet keys.png --plot curves.svg",
        files: &["keys.png", "curves.svg"],
        share: 3,
    },
    Step {
        name: STATISTICS,
        title: "Shots",
        section: "§3.1.1, table 1",
        does: "Shots are counted by whether the background moves.",
        formula: "p = n_static / (n_static + n_dynamic), the part of shots whose background does not move",
        line: "video statistics film/left.y4m film/right.y4m",
        files: &[],
        share: 3,
    },
    Step {
        name: QUALITY,
        title: "Quality of the film",
        section: "§3.4.3, fig. 12",
        does: "The film with its noise is compared with the same film without noise, as a codec \
               would be judged.",
        formula: "PSNR = 10 log₁₀ 255² / MSE, also with each block weighted by attention",
        line: "quality compare film/clean.y4m film/part.y4m --csv quality.csv --plot quality.svg",
        files: &["quality.csv", "quality.svg"],
        share: 4,
    },
    Step {
        name: COMFORT,
        title: "Comfort before",
        section: "§3.4.2",
        does: "Eleven checks say what would strain the eyes of a viewer with 3-D glasses: the \
               right picture is too bright, rolled and raised, and everything lies before the \
               screen.",
        formula: "eleven scores from 0 to 15: green to 7, orange to 13, red above",
        line: "video comfort film/left.y4m film/right.y4m --layout two-files \
               --summary comfort.json --out comfort.html",
        files: &["comfort.html", "comfort.json"],
        share: 6,
    },
    Step {
        name: ALIGNMENT,
        title: "Alignment",
        section: "§3.4.2",
        does: "Roll, height, scale and light of the right view are made those of the left one, \
               and the depth is put about the screen.",
        formula: "x′ = T R D x ~(T R D): shift, roll and scale of the right view; its light as that \
                  of the left",
        line: "video align film/left.y4m film/right.y4m --out aligned.y4m \
               --shift-parallax recommended",
        files: &["aligned.y4m"],
        share: 6,
    },
    Step {
        name: ALIGNED,
        title: "Comfort after",
        section: "§3.4.2, table 6",
        does: "The same checks on the aligned film.",
        formula: "the same eleven scores",
        line: "video comfort aligned.y4m --layout side-by-side --summary aligned.json \
               --out aligned.html",
        files: &["aligned.html", "aligned.json"],
        share: 6,
    },
    Step {
        name: SKIN,
        title: "The skin of a moment",
        section: "§2.3.3",
        does: "The fitted body at one moment, as a mesh: the motors of the bones are blended at \
               each vertex.",
        formula: "x′ = G x ~G with G = Σ wᵢ Gᵢ, normalised",
        line: "skin person/character.glb --animation 0 --time 0.48 --method motor --out posed.obj",
        files: &["posed.obj"],
        share: 1,
    },
    Step {
        name: SUBDIVISION,
        title: "Subdivision",
        section: "§3.3.2, table 4",
        does: "Each triangle is split into four, and the vertices move to those of a smooth \
               surface (Loop's scheme).",
        formula: "V → V + E vertices, F → 4 F faces",
        line: "mesh subdivide posed.obj --levels 1 --out fine.obj",
        files: &["fine.obj"],
        share: 2,
    },
    Step {
        name: TEXTURE,
        title: "Texture from the views",
        section: "§2.1.3",
        does: "The colours of the skin are taken from the two pictures of that moment; what \
               neither shows is filled from beside.",
        formula: "an affine map of the corners of each triangle p ∧ q ∧ r ∧ e∞ to pixels of the \
                  views that see it",
        line: "texture posed.obj --views views.json --size 768 --out textured.glb",
        files: &["textured.glb"],
        share: 4,
    },
    Step {
        name: TEXTURED_VIEW,
        title: "The textured figure",
        section: "§2.1.3",
        does: "The figure with the skin that the two pictures gave it.",
        formula: "pixel = K (M P ~M), of the points of all triangles",
        line: "render textured.glb --camera front --size 480x640 --out textured.png",
        files: &["textured.png"],
        share: 1,
    },
    Step {
        name: MAPS,
        title: "Baked maps",
        section: "§3.3.2, table 5",
        does: "What the fine mesh has more than the coarse one, kept in pictures for the coarse \
               one: its normals, and its height.",
        formula: "the height of the fine surface along the normals of the coarse one",
        line: "mesh bake --fine fine.obj --coarse posed.obj --maps normal,displacement \
               --size 1024 --out baked",
        files: &[
            "baked/coarse.glb",
            "baked/normal.png",
            "baked/displacement.png",
        ],
        share: 5,
    },
    Step {
        name: OPERATIONS,
        title: "What a motor costs",
        section: "§2.3.1, §2.3.2",
        does: "The compiler of `ga!` counts what it costs to move a point by a motor: products of \
               blades that are zero, or the same twice, are found by itself and not computed.",
        formula: "M P ~M, of a motor with 8 numbers and a conformal point with 3",
        line: "expand --expr 'fn moved(m: Motor, p: Point) -> Point { m * p * rev(m) }' --emit ops",
        files: &[],
        share: 1,
    },
];
