//! The macros by which algebras are declared and functions in them compiled.

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
/// `basis` names up to 16 vectors; a blade is named by joining what follows their common prefix:
/// `e1`, `e2`, `eo` give `e12`, `e1o`, `e2o`, and `e21` for `−e12`. The metric is
/// `signature p, q, r;` (squares 1, −1, 0) or any constant symmetric form, where products not
/// stated are zero:
///
/// ```text
/// metric e1*e1 = 1, e2*e2 = 1, e3*e3 = 1, eo*ei = -1;
/// ```
///
/// # Types
///
/// A type lists its blades, `scalar` being the blade of grade 0. A blade is *stored* (`e1`),
/// *constant* (`eo = 1`) or *derived* from stored ones (`ei = (e1*e1 + e2*e2 + e3*e3)/2`). A type
/// without stored blades is a constant and takes no scalar parameter. `#[facts(…)]` states what
/// every member satisfies:
///
/// | fact | meaning |
/// | --- | --- |
/// | `unit_versor` | `M ~M = 1` in every grade: for motors the Study condition too |
/// | `null` | `X² = 0` |
/// | `blade` | X is an outer product of vectors |
/// | `weight(b)` | the coefficient of the blade b is 1 |
///
/// All but `unit_versor` must follow from constant and derived blades. `#[hull(Type)]` names the
/// type of sums and multiples wherever they leave the type; it must store all the blades.
///
/// Fields are public where any coefficients make a member. Elsewhere they are private, with a
/// reader for each blade, and a type whose facts restrict its coefficients is built by
/// `new_unchecked`, `try_new(…, tolerance)` or `normalize(hull)`.
///
/// # Products
///
/// `products` lists what is emitted: `geometric` (`*`), `wedge` (`^`), `left_contraction` (`|`),
/// `vee` (`&`), `right_contraction`, `scalar_product`, `commutator`, `sandwich`, `dual`, `undual`.
/// Braces list several types in one line. The result is stated with `->`, where `Self` is the type
/// of the last operand and `Scalar` a plain number, or left out where exactly one declared type
/// without facts has just the blades of the result. That a result lies in its type is proved when
/// the macro runs, by exact evaluation at random points.
///
/// # The other half
///
/// Beside the module there is a macro of the same name, which hands the definition to macros such
/// as `ga_runtime::testing::product_tests!`. `crate = path;` before the basis says where the
/// emitted code finds ga-runtime, if not through this macro.
#[macro_export]
macro_rules! algebra {
    ($($declaration:tt)*) => {
        $crate::__private::macros::algebra! { [$crate] $($declaration)* }
    };
}

/// Compiles functions written in an algebra, each as one piece.
///
/// A person writes textbook algebra and gets straight-line code: only the coefficients of the
/// result are worked out, constants fold, common parts are shared, and the unit norm of a motor or
/// the null square of a point is made use of. What the code does is checked against the plain
/// meaning of the formula, exactly, before it is emitted.
///
/// ```
/// use ga_runtime::cga3::{Motor, Plane, Point, Rotor};
/// use ga_runtime::ga;
///
/// ga! { ga_runtime::cga3;
///     /// The point moved: 21 multiplications and 18 additions.
///     pub fn moved(m: Motor, p: Point) -> Point { m * p * reverse(m) }
///
///     /// The plane through three points, and its distance from a fourth times the size of the triangle's cross product.
///     fn plane_and_height(p: Point, q: Point, r: Point, s: Point) -> (Plane, Scalar) {
///         let plane = p ^ q ^ r ^ ei;
///         (plane, dual(plane) | s)
///     }
/// }
///
/// # fn main() {
/// let quarter = Rotor::from_axis_angle([0.0, 0.0, 1.0], std::f64::consts::FRAC_PI_2).unwrap();
/// let p = moved(Motor::from(quarter), Point::new(1.0, 0.0, 2.0));
/// assert!((p.e2() - 1.0).abs() < 1e-15 && p.e3() == 2.0);
///
/// let [p, q, r, s] =
///     [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 3.0]].map(Point::from);
/// let (plane, height): (Plane<f64>, f64) = plane_and_height(p, q, r, s);
/// assert_eq!((plane.e123i, height.abs()), (0.0, 3.0));
/// # }
/// ```
///
/// # Functions
///
/// `ga! { path::of::algebra; functions… }` gives functions generic over the scalar, with the
/// weakest bound that the body needs: [`Ring`](crate::scalar::Ring),
/// [`Field`](crate::scalar::Field) or [`Real`](crate::scalar::Real). Types are those of the algebra
/// by name, `Scalar`, arrays `[Point; 3]` and tuples. A body is a row of `let` statements, patterns
/// included, and the formula of the result. Functions of one block may call each other, and with
/// `use path::of::function;` at its start those of another; the calls are compiled as if they were
/// written out. A closure, `ga! { cga3; |p: Point, q: Point| -> Scalar { p | q } }`, is an
/// expression.
///
/// | written | means |
/// | --- | --- |
/// | `a * b`, `a ^ b`, <code>a &#124; b</code>, `a & b` | geometric product, wedge, left contraction, vee |
/// | `a + b`, `a - b`, `-a`, `a / x` | sum, difference, negative, quotient by a scalar |
/// | `geometric`, `wedge`, `left_contraction`, `right_contraction`, `scalar_product`, `commutator`, `vee` | the products by name |
/// | `reverse` or `rev`, `involute`, `conjugate`, `dual`, `undual`, `grade(a, 2)` | linear operations |
/// | `sandwich(m, x)` or `transform` | `m x ~m`, for odd m `m x̂ ~m` |
/// | `norm_squared`, `norm`, `normalize`, `inverse` or `inv` | `⟨a ~a⟩₀`, its root, `a` with norm 1, `~a/(a ~a)` |
/// | `exp`, `log` | of scalars; exp of bivectors, log of even unit versors, where B² is a scalar but for a null part |
/// | `sqrt`, `abs`, `sin`, `cos`, `atan2(y, x)`, `ln`, `recip` | of scalars |
/// | `2`, `0.5`, `e12`, `Infinity` | exact numbers, basis blades, constant types |
/// | `a.e12`, `xs[0]`, `t.1` | a coefficient; an element of an array or tuple |
///
/// Each operation is a function and a method: `reverse(m)` is `m.reverse()`. Precedence is that of
/// Rust, where `^ & |` bind looser than `+ - * /`; a mix of both without parentheses is an error
/// that shows both readings.
///
/// # Types of results
///
/// A result is returned as a `Point` only if it is one, weight 1 and null; otherwise the error says
/// what was found, and whether a division by the weight would do. `let x: Line = …` checks a value
/// on the way.
///
/// Divisions by zero and roots of negative numbers follow the scalar: they give infinities or NaN
/// over floats.
///
/// ```standalone_crate
/// mod kernels {
///     ga_runtime::ga! { ga_runtime::cga3;
///         /// The reflection of a point in a plane.
///         pub fn reflected(p: Point, plane: Plane) -> RoundVector { sandwich(dual(plane), p) }
///     }
/// }
/// ga_runtime::ga! { ga_runtime::cga3;
///     use crate::kernels::reflected;
///     /// Two reflections: a motion. Nothing of the point between them is worked out that does not count.
///     pub fn reflected_twice(p: Point, a: Plane, b: Plane) -> Scalar {
///         ei | sandwich(dual(b), reflected(p, a))
///     }
/// }
/// # fn main() {}
/// ```
///
/// # Uniform operands
///
/// An operand marked `uniform` stays the same over many calls. The function then takes the uniform
/// operands alone and gives a struct, called like the function in camel case, that holds all work
/// done on them; its `apply` takes the rest. `map` changes the scalar, to lanes for instance.
///
/// ```
/// use ga_runtime::cga3::{Motor, Point, Translator};
///
/// ga_runtime::ga! { ga_runtime::cga3;
///     /// A motor becomes its 3×4 matrix once; each point takes 9 multiplications and 9 additions.
///     fn moving(uniform m: Motor, p: Point) -> Point { m * p * reverse(m) }
/// }
///
/// # fn main() {
/// let moving = moving(Motor::from(Translator::from_displacement([1.0, 0.0, 0.0])));
/// let moved = [[0.0; 3], [1.0, 2.0, 3.0]].map(|p| moving.apply(Point::from(p)).coordinates());
/// assert_eq!(moved, [[1.0, 0.0, 0.0], [2.0, 2.0, 3.0]]);
/// # }
/// ```
#[macro_export]
macro_rules! ga {
    ($($path:ident)::+ ; $($functions:tt)*) => {
        $($path)::+ ! { [$crate::__private::macros::functions] [$($path)::+] $($functions)* }
    };
    (:: $($path:ident)::+ ; $($functions:tt)*) => {
        :: $($path)::+ ! { [$crate::__private::macros::functions] [:: $($path)::+] $($functions)* }
    };
}
