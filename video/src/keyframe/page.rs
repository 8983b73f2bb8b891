//! The analysis of a video as a page.

use ga_draw::document::Page;

use super::reading::Analysed;
use super::statistics::Statistics;
use super::timecode::TimeBase;

impl Analysed {
    /// The page: counts, the curves, which the chart `svg` shows, the shots, and the key frames as
    /// a picture.
    #[must_use]
    pub fn page(&self, title: &str, svg: &str, key_frames_png: &[u8]) -> Page {
        let analysis = &self.analysis;
        let statistics = Statistics::of(&analysis.shots);
        let [width, height] = self.properties.size;
        let mut page = Page::new(title);
        if let Some(failure) = &self.failure {
            page.warning(&format!(
                "The video could not be read to its end: {failure}"
            ));
        }
        page.paragraph(&format!(
            "Frames: {}, of {width} × {height} pixels. Shots: {}, {} with static and {} with \
             dynamic background. Key frames: {}.",
            analysis.frames.len(),
            statistics.shots(),
            statistics.static_shots,
            statistics.dynamic_shots,
            analysis.key_frames.len()
        ));
        page.svg(svg);
        page.paragraph(&self.transitions());
        page.heading("Shots");
        let (times, base) = (self.times(None), self.rate());
        let base = base.and_then(|rate| TimeBase::new(rate, None).ok());
        let shown = |frame: usize| match base {
            Some(base) => base.code(times[frame]),
            None => format!("{:.3} s", times[frame]),
        };
        let shots = analysis.shots.iter().enumerate();
        let rows = shots.map(|(number, shot)| {
            let frames = &shot.frames;
            [
                (number + 1).to_string(),
                shown(frames.start),
                shown(frames.end),
                format!("{}–{}", frames.start, frames.end),
                shot.background.name().to_owned(),
            ]
        });
        page.table(["shot", "from", "to", "frames", "background"], rows);
        page.heading("Key frames");
        page.png("The key frames", key_frames_png);
        page
    }

    /// A sentence about the cuts, dissolves and fades; the chart shades the latter two.
    fn transitions(&self) -> String {
        let transitions = &self.analysis.transitions;
        let blended = transitions.blended();
        let shaded = match blended.is_empty() {
            true => String::new(),
            false => format!(" Shaded: {}.", blended.join("; ")),
        };
        let cuts = transitions.cuts.iter().map(usize::to_string);
        let cuts = match transitions.cuts.len() {
            0 => "No cuts".into(),
            1..=40 => format!("Cuts at frames {}", cuts.collect::<Vec<_>>().join(", ")),
            count => format!("{count} cuts"),
        };
        format!("{cuts}.{shaded}")
    }
}
