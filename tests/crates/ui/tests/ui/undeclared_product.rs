//! A versor times what it moves is not a declared product; the error names `transform`.

use ga_runtime::cga3::{Line, Motor, Point};

fn moved(motor: Motor<f64>, point: Point<f64>, line: &Line<f64>) {
    let _ = motor * point;
    let _ = &motor * *line;
}

fn main() {}
