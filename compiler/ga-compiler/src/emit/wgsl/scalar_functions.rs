//! Functions of scalars in WGSL: built-in ones, and our own where WGSL has none.

use std::cell::RefCell;

use crate::ir::Function;

/// The functions of our own that the declaration of another calls.
pub(super) fn needs(function: Function) -> Vec<Function> {
    let called = RefCell::new(Vec::new());
    let note = |other: Function| {
        if other != function {
            called.borrow_mut().push(other);
        }
        String::new()
    };
    declaration(function, &note);
    called.into_inner()
}

/// Whether a function is declared by us.
pub(super) fn is_own(function: Function) -> bool {
    declaration(function, &|_| String::new()).is_some()
}

/// The declaration of a function of our own; `name` gives the names under which they are declared.
///
/// Near zero the closed forms divide rounding errors by small numbers, so their series are taken
/// there, to the last term that single precision sees.
pub(super) fn declaration(function: Function, name: &dyn Fn(Function) -> String) -> Option<String> {
    let this = name(function);
    match function {
        Function::StumpffCosine => Some(stumpff_cosine(&this)),
        Function::StumpffSine => Some(stumpff_sine(&this)),
        Function::StumpffSineSlope => {
            let (cosine, sine) = (name(Function::StumpffCosine), name(Function::StumpffSine));
            Some(stumpff_sine_slope(&this, &cosine, &sine))
        }
        Function::VersorAngle => Some(versor_angle(&this)),
        Function::VersorAngleSlope => Some(versor_angle_slope(&this, &name(Function::VersorAngle))),
        // The built-in functions may lose all digits near zero.
        Function::HyperbolicSine => Some(hyperbolic_sine(&this, &name(Function::StumpffSine))),
        Function::HyperbolicTangent => {
            let (cosine, sine) = (name(Function::StumpffCosine), name(Function::StumpffSine));
            Some(hyperbolic_tangent(&this, &cosine, &sine))
        }
        Function::Hypotenuse => Some(hypotenuse(&this)),
        Function::Reciprocal => Some(reciprocal(&this)),
        Function::Divisor => Some(divided(&this)),
        _ => None,
    }
}

fn reciprocal(this: &str) -> String {
    format!(
        "\
// 1/x, and 0 where x is 0.
fn {this}(x: f32) -> f32 {{
    if x == 0.0 {{
        return 0.0;
    }}
    return 1.0 / x;
}}
"
    )
}

fn divided(this: &str) -> String {
    format!(
        "\
// a/x, and 0 where x is 0.
fn {this}(a: f32, x: f32) -> f32 {{
    if x == 0.0 {{
        return 0.0;
    }}
    return a / x;
}}
"
    )
}

fn stumpff_cosine(this: &str) -> String {
    format!(
        "\
// C(x) of exp B = C(B²) + S(B²) B: cos √−x or cosh √x.
fn {this}(x: f32) -> f32 {{
    let root = sqrt(abs(x));
    if x > 0.0 {{
        return 0.5 * (exp(root) + exp(-root));
    }}
    return cos(root);
}}
"
    )
}

fn stumpff_sine(this: &str) -> String {
    format!(
        "\
// S(x) of exp B = C(B²) + S(B²) B: sin √−x / √−x or sinh √x / √x.
fn {this}(x: f32) -> f32 {{
    if abs(x) < 1.0 {{
        return 1.0 + x * (1.0 / 6.0 + x * (1.0 / 120.0 + x * (1.0 / 5040.0 + x * (1.0 / 362880.0 + x / 39916800.0))));
    }}
    let root = sqrt(abs(x));
    if x > 0.0 {{
        return 0.5 * (exp(root) - exp(-root)) / root;
    }}
    return sin(root) / root;
}}
"
    )
}

fn stumpff_sine_slope(this: &str, cosine: &str, sine: &str) -> String {
    format!(
        "\
// The derivative of S, (C − S)/(2x).
fn {this}(x: f32) -> f32 {{
    if abs(x) < 1.0 {{
        return 1.0 / 6.0 + x * (1.0 / 60.0 + x * (1.0 / 1680.0 + x * (1.0 / 90720.0 + x / 7983360.0)));
    }}
    return ({cosine}(x) - {sine}(x)) / (2.0 * x);
}}
"
    )
}

fn versor_angle(this: &str) -> String {
    format!(
        "\
// 1/S(B²) from C(B²) and S(B²)² B²: half the angle of a rotation over its sine.
fn {this}(cosine: f32, square: f32) -> f32 {{
    // At cosine −1 the bivector is not determined. A hyperbolic versor with a negative cosine has
    // no logarithm, but its negative has one.
    let is_negative = cosine < 0.0 && square > 0.0;
    if abs(square) < 0.0625 && (cosine > 0.0 || square >= 0.0) {{
        let series = 1.0 + square * (-1.0 / 6.0 + square * (3.0 / 40.0 + square * (-5.0 / 112.0 + square * (35.0 / 1152.0 - square * 63.0 / 2816.0))));
        return select(series, -series, is_negative);
    }}
    let sine = sqrt(abs(square));
    if square > 0.0 {{
        let ratio = log(sine + sqrt(1.0 + square)) / sine;
        return select(ratio, -ratio, is_negative);
    }}
    return atan2(sine, cosine) / sine;
}}
"
    )
}

fn versor_angle_slope(this: &str, angle: &str) -> String {
    format!(
        "\
// −2 S′(B²)/S(B²)³ from C(B²) and S(B²)² B².
fn {this}(cosine: f32, square: f32) -> f32 {{
    if abs(square) < 0.0625 && (cosine > 0.0 || square >= 0.0) {{
        return -1.0 / 3.0 + square * (2.0 / 15.0 + square * (-8.0 / 105.0 + square * (16.0 / 315.0 - square * 128.0 / 3465.0)));
    }}
    return (1.0 - cosine * {angle}(cosine, square)) / square;
}}
"
    )
}

fn hyperbolic_sine(this: &str, sine: &str) -> String {
    format!(
        "\
// sinh x.
fn {this}(x: f32) -> f32 {{
    return x * {sine}(x * x);
}}
"
    )
}

fn hyperbolic_tangent(this: &str, cosine: &str, sine: &str) -> String {
    format!(
        "\
// tanh x.
fn {this}(x: f32) -> f32 {{
    // Beyond 10 it is ±1 in single precision, and sinh x and cosh x overflow far beyond.
    let bounded = clamp(x, -10.0, 10.0);
    let square = bounded * bounded;
    return bounded * {sine}(square) / {cosine}(square);
}}
"
    )
}

fn hypotenuse(this: &str) -> String {
    format!(
        "\
// √(x² + y²), without overflow in the squares.
fn {this}(x: f32, y: f32) -> f32 {{
    let size = max(abs(x), abs(y));
    if size == 0.0 {{
        return 0.0;
    }}
    let ratio = min(abs(x), abs(y)) / size;
    return size * sqrt(1.0 + ratio * ratio);
}}
"
    )
}
