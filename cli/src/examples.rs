//! The help of each command in one form: what it does in a line, and an example at the end.

use clap::Command;

/// How commands are called, after the name of the program. The example of a command with others
/// below it is the first of theirs.
const EXAMPLES: [&str; 49] = [
    "demo --bones --trails LeftFoot,RightHand --film walk.png",
    "animate --character hero.glb --motion walk.bvh --foot-locking --out hero",
    "body fit --joints joints.json --rig rig.yml --character mannequin --out p.glb",
    "body evaluate --motion walk.bvh --noise 0,1,2,4 --views 1,2,4 --plot p.svg",
    "body paint --out dotted.glb",
    "body dots front.y4m side.y4m --views views.json --out joints.json",
    "camera calibrate '*.jpg' --board 9x6 --square 0.025 --out camera.yml",
    "camera calibrate-rig --board 9x6 --square 0.025 --views 'a/*' --views 'b/*' --out rig.toml",
    "camera convert camchain.yaml --out rig.yml",
    "capture points.csv --calibrated brow,nose,left,right --out expression.csv",
    "expand --expr 'fn f(m: Motor, p: Point) -> Point { m * p * rev(m) }' --emit ops",
    "clip compress walk.bvh --tolerance 0.0001 --out walk.clip",
    "clip info walk.clip --json",
    "clip sample walk.clip --times 0,0.25,1.5 --json",
    "clip convert walk.clip --out walk.bvh",
    "clip resample walk.clip --rate 30 --out walk-30.clip",
    "clip retarget walk.bvh --target hero.glb --foot-locking --out hero-walks.glb",
    "clip mirror walk.clip --out walk-mirrored.clip",
    "clip blend walk.clip run.clip --weights 0.7,0.3 --align-phases --loop --out jog.clip",
    "contour coins.png --out coins.svg --json",
    "curve path.csv --ends natural --tolerance 0.01 --out curve.csv --plot curve.svg",
    "draw scene.json --out scene.html",
    "merge part-0.y4m part-1.y4m --out film.y4m",
    "mesh convert scan.ply scan.obj",
    "mesh info bunny.obj --json",
    "mesh subdivide cube.obj --levels 3 --out smooth.obj",
    "mesh bake --fine scan.obj --coarse game.obj --maps normal,colour --out baked",
    "people a.mp4 b.mp4 --joints a.json b.json --views views.json --out person",
    "quality compare original.y4m compressed.y4m --csv frames.csv --plot frames.svg",
    "quality fit scores.csv --report fit.html",
    "quality ratings table.csv --screen --report ratings.html",
    "render model.glb --camera three-quarter --out model.png",
    "skin fox.glb --animation 2 --time 0.35 --method motor --out frame.obj",
    "stereo match left.png right.png --max-disparity 64 --out d.pfm --picture d.png",
    "stereo calibrate --board 9x6 --square 0.025 --left 'left*.jpg' --right 'right*.jpg' \
     --out rig.yml",
    "stereo evaluate d.pfm truth.png --scale 4 --json",
    "stereo pose left.png right.png --camera K.yml --json",
    "stereo rectify left.jpg right.jpg --rig rig.yml --alpha 0 --out rectified",
    "stereo undistort left01.jpg --camera left.yml --out straight.png",
    "stereo diagnose left.png right.png --json",
    "stereo reconstruct left.jpg right.jpg --rig rig.yml --out model.glb",
    "texture statue.obj --views views/views.json --out model.glb",
    "video keyframes film.y4m --out keys --contact-sheet sheet.png",
    "video align film.y4m --out aligned.y4m",
    "video comfort film.y4m --layout side-by-side --out report.html",
    "video score found.json labels.csv --tolerance 1",
    "video statistics first.y4m second.y4m --json",
    "completions bash",
    "man --out man1",
];

/// A command with an example in its help and in that of each command below it.
pub(crate) fn with_examples(command: Command) -> Command {
    add(command, "")
}

fn add(command: Command, words: &str) -> Command {
    let names = command
        .get_subcommands()
        .map(|below| below.get_name().to_owned());
    let names: Vec<String> = names.collect();
    let command = names.into_iter().fold(command, |command, name| {
        let words = format!("{words} {name}");
        command.mut_subcommand(name, |below| add(below, words.trim_start()))
    });
    let command = match command.get_about().map(ToString::to_string) {
        Some(about) => command.about(one_line(&about)),
        None => command,
    };
    let is_of_it = |example: &&&str| {
        let rest = example.strip_prefix(words);
        rest.is_some_and(|rest| rest.starts_with(' '))
    };
    match EXAMPLES.iter().find(is_of_it) {
        Some(example) => command.after_help(format!("Example:\n  nullcone {example}")),
        None => command,
    }
}

/// What a command does, as a line of a list: without line ends and the full stop.
fn one_line(about: &str) -> String {
    let words: Vec<&str> = about.split_whitespace().collect();
    words.join(" ").trim_end_matches('.').to_owned()
}
