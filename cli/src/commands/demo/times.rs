//! Measured times, which differ from run to run: the only place where the demonstration has them.

use anyhow::Result;
use nullcone_speed::Speed;

/// The file beside the page.
pub(super) const FILE: &str = "times.js";

/// Seconds of each step, by its name.
#[derive(Debug, Default)]
pub(super) struct Times {
    pub(super) steps: Vec<(String, f64)>,
}

impl Times {
    /// The script of the page, also with how fast points are moved.
    pub(super) fn script(&self, speed: Speed) -> Result<String> {
        let mut names = serde_json::Map::new();
        for (name, seconds) in &self.steps {
            names.insert(name.clone(), format!("{seconds:.2} s").into());
        }
        for (name, nanoseconds) in [
            ("motor", speed.motor_nanoseconds),
            ("glam", speed.glam_nanoseconds),
        ] {
            names.insert(name.to_owned(), format!("{nanoseconds:.2} ns").into());
        }
        Ok(format!(
            "for (const [name, time] of Object.entries({})) {{\n  \
             for (const place of document.querySelectorAll(`[data-time=\"${{name}}\"]`)) {{\n    \
             place.textContent = time;\n  }}\n}}\n",
            serde_json::to_string_pretty(&names)?
        ))
    }
}
