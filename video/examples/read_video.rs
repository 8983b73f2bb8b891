//! Reads a video to its end: how many frames, how quickly, and the most memory that was taken.
//!
//! `cargo run --release -p ga-vision --example read_video -- FILE` (`-` for standard input)

use std::time::Instant;

use ga_video::{Frame, open};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let path = std::env::args().nth(1).ok_or("which file?")?;
    let start = Instant::now();
    let mut source = open(path)?;
    println!("{:?}", source.properties());
    let (mut frame, mut frames, mut bytes) = (Frame::default(), 0, 0);
    let outcome = loop {
        match source.read(&mut frame) {
            Ok(true) => {
                frames += 1;
                let [width, height] = frame.samples.size();
                bytes += width * height;
            }
            Ok(false) => break Ok(()),
            Err(error) => break Err(error),
        }
    };
    let seconds = start.elapsed().as_secs_f64();
    println!(
        "{frames} frames in {seconds:.2} s, {:.1} a second, {:.2} gigapixels a second",
        f64::from(frames) / seconds,
        bytes as f64 / seconds / 1e9
    );
    // Linux states the greatest memory of a process here.
    if let Ok(status) = std::fs::read_to_string("/proc/self/status") {
        let peak = status.lines().find(|line| line.starts_with("VmHWM"));
        println!("{}", peak.unwrap_or_default());
    }
    Ok(outcome?)
}
