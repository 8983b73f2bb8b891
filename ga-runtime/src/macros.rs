//! The macros by which algebras are declared.

/// Declares a geometric algebra: its basis, its types and the products between them.
///
/// ```
/// ga_runtime::algebra! {
///     /// The plane.
///     pub mod vga2 {
///         basis e1, e2;
///         signature 2, 0, 0;
///
///         /// A direction in the plane.
///         struct Vector { e1, e2 }
///         /// An oriented area.
///         struct Bivector { e12 }
///         /// Any sum of scalar and bivector: the complex numbers.
///         struct Complex { scalar, e12 }
///         /// A turn about the origin.
///         #[hull(Complex)]
///         #[facts(unit_versor)]
///         struct Rotor { scalar, e12 }
///
///         products {
///             wedge(Vector, Vector);
///             left_contraction(Vector, Vector) -> Scalar;
///             geometric(Vector, Vector) -> Complex;
///             geometric(Rotor, Rotor) -> Rotor;
///             sandwich(Rotor, Vector) -> Self;
///         }
///     }
/// }
/// use vga2::{Bivector, Rotor, Vector};
///
/// # fn main() {
/// let (a, b) = (Vector::new(3.0, 0.0), Vector::new(1.0, 2.0));
/// assert_eq!(a ^ b, Bivector::new(6.0));
/// // The turn by 90°, R = cos 45° − sin 45° e12.
/// let quarter = Rotor::try_new(0.5_f64.sqrt(), -0.5_f64.sqrt(), 1e-12).unwrap();
/// let turned = quarter.transform(a);
/// assert!(turned.e1.abs() < 1e-12 && (turned.e2 - 3.0).abs() < 1e-12);
/// # }
/// ```
///
/// # Basis and metric
///
/// `basis` names up to 16 vectors; a blade is named by joining what follows their common prefix: `e1`, `e2`, `eo` give
/// `e12`, `e1o`, `e2o`, and `e21` for `−e12`. The metric is `signature p, q, r;` (squares 1, −1, 0) or any constant
/// symmetric form, where products not stated are zero:
///
/// ```text
/// metric e1*e1 = 1, e2*e2 = 1, e3*e3 = 1, eo*ei = -1;
/// ```
///
/// # Types
///
/// A type lists its blades, `scalar` being the blade of grade 0. A blade is *stored* (`e1`), *constant* (`eo = 1`) or *derived*
/// from stored ones (`ei = (e1*e1 + e2*e2 + e3*e3)/2`). A type without stored blades is a constant and takes no
/// scalar parameter. `#[facts(…)]` states what every member satisfies:
///
/// | fact | meaning |
/// | --- | --- |
/// | `unit_versor` | `M ~M = 1` in every grade: for motors the Study condition too |
/// | `null` | `X² = 0` |
/// | `blade` | X is an outer product of vectors |
/// | `weight(b)` | the coefficient of the blade b is 1 |
///
/// All but `unit_versor` must follow from constant and derived blades. `#[hull(Type)]` names the type of sums and multiples
/// wherever they leave the type; it must store all the blades.
///
/// Fields are public where any coefficients make a member. Elsewhere they are private, with a reader for each blade,
/// and a type whose facts restrict its coefficients is built by `new_unchecked`, `try_new(…, tolerance)` or
/// `normalize(hull)`.
///
/// # Products
///
/// `products` lists what is emitted: `geometric` (`*`), `wedge` (`^`), `left_contraction` (`|`), `vee` (`&`),
/// `right_contraction`, `scalar_product`, `commutator`, `sandwich`, `dual`, `undual`. Braces list several types in
/// one line. The result is stated with `->`, where `Self` is the type of the last operand and `Scalar` a plain number, or left
/// out where exactly one declared type without facts has just the blades of the result. That a result lies in its type is proved when
/// the macro runs, by exact evaluation at random points.
///
/// # The other half
///
/// Beside the module there is a macro of the same name, which hands the definition to macros such as
/// `ga_runtime::testing::product_tests!`. `crate = path;` before the basis says where the emitted code finds
/// ga-runtime, if not through this macro.
#[macro_export]
macro_rules! algebra {
    ($($declaration:tt)*) => {
        $crate::__private::macros::algebra! { [$crate] $($declaration)* }
    };
}
