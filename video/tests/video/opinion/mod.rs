//! Scores of measures beside opinions, against SciPy, plain counting and printed examples.

mod correlation;
mod logistic;
mod performance;
mod ratings;

use ga_video::opinion::Scores;

/// The scores of three measures beside real opinion scores, with what SciPy found; `None` where the
/// shared data is absent.
fn oracle() -> Option<Vec<(Scores, serde_json::Value)>> {
    let path = nullcone_shared_data::shared("oracle/vision/seed1/truth.json")?;
    let truth: serde_json::Value = serde_json::from_slice(&std::fs::read(path).unwrap()).unwrap();
    let numbers = |value: &serde_json::Value| -> Vec<f64> {
        value
            .as_array()
            .unwrap()
            .iter()
            .map(|v| v.as_f64().unwrap())
            .collect()
    };
    let entries = truth["logistic_vqeghd3"].as_array().unwrap();
    assert_eq!(entries.len(), 3);
    let scores = entries.iter().map(|entry| {
        let scores = Scores::new(numbers(&entry["x"]), numbers(&entry["mos"])).unwrap();
        (scores, entry.clone())
    });
    Some(scores.collect())
}
