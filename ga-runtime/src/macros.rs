//! The macros that declare algebras and compile functions in them.

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
///         /// A rotation about the origin.
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
/// // The rotation by 90°, R = cos 45° − sin 45° e12.
/// let quarter = Rotor::try_new(0.5_f64.sqrt(), -0.5_f64.sqrt(), 1e-12).unwrap();
/// let rotated = quarter.transform(a);
/// assert!(rotated.e1.abs() < 1e-12 && (rotated.e2 - 3.0).abs() < 1e-12);
/// # }
/// ```
///
/// # Basis and metric
///
/// `basis` names up to 16 vectors. The name of a blade joins the names of its vectors after their
/// common prefix: `e1`, `e2`, `eo` give `e12`, `e1o`, `e2o`; another order changes the sign, `e21`
/// is `−e12`. The metric is given in one of three ways:
///
/// ```text
/// basis e0 = 0, e1 = 1, e2 = 1;
///
/// basis e1, e2, e3, e0;
/// signature 3, 0, 1;
///
/// basis e1, e2, e3, eo, ei;
/// metric e1*e1 = 1, e2*e2 = 1, e3*e3 = 1, eo*ei = -1;
/// ```
///
/// - The square stands beside each vector, `basis e0 = 0, e1 = 1;`. Products of two vectors may
///   follow, `metric eo*ei = -1;`; those that are not stated are zero.
/// - `signature p, q, r;` has the squares in the order in which `basis` names the vectors: p times
///   1, then q times −1, then r times 0. So `basis e1, e2, e0; signature 2, 0, 1;` means `e0² = 0`,
///   while with `basis e0, e1, e2;` the same signature means `e2² = 0`. Other libraries make e0
///   null, so the compiler warns of the latter.
/// - `metric` states the products entry by entry: any constant symmetric form.
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
/// All facts except `unit_versor` and `blade` must follow from constant and derived blades. A type
/// whose blades satisfy the Plücker relations may state `blade`: products of its members are then
/// known to be blades where geometry says so, for instance that the meet of a line and a sphere is
/// a point pair, whose square is a scalar. `#[hull(Type)]` names the type of sums and multiples
/// that do not lie in the type itself; it must store all the blades.
///
/// If any coefficients make a member of the type, its fields are public. Otherwise they are
/// private, with a method for each blade that returns its coefficient, and a type whose facts
/// restrict its coefficients is built by `new_unchecked` or `try_new(…, tolerance)`, one of unit
/// versors also by `normalize(hull)`.
///
/// # Types by parameters
///
/// A type may list *parameters* in place of blades: numbers, or members of a type of blades. It is
/// stored as these, in public fields of their names, and `new` takes them in their order.
///
/// ```text
/// #[hull(RoundVector)]
/// struct DualSphere {
///     weight, centre: Point, radius_squared;
///     self = weight * (centre - radius_squared / 2 * ei);
///     weight = -(ei | self);
///     radius_squared = (self | self) / (weight * weight);
///     centre = self / weight + radius_squared / 2 * ei;
/// }
/// ```
///
/// `self = …` is the multivector that the parameters stand for, a formula as in [`ga!`](crate::ga).
/// Its blades are blades of the hull, which is the type of sums. The formulas after it are
/// *readings*: how each parameter follows from a multivector `self`, from parameters that are read
/// above, and from what `let` binds. There is one for each parameter, or none at all: a type
/// without readings is only an operand, such as one of two joint angles that stand for a rotation.
/// The compiler checks at random members that the parameters read give the multivector back, and
/// that the facts of the type follow. In readings a quotient by zero is zero, so that any
/// multivector has parameters. `TryFrom` and `try_from_element` refuse one that they do not give
/// back.
///
/// Products are computed with the parameters; their results are read, so that what is not needed of
/// the multivector is not computed. Of what a versor makes of a member, parameters that stay or are
/// moved are not read anew. In `ga!`, `x.centre` is a parameter. The coefficients of blades have
/// the methods of every type, and text is written by blades; serde writes parameters by name.
///
/// # Products
///
/// `products` lists the products to emit: `geometric` (`*`), `wedge` (`^`), `left_contraction`
/// (`|`), `vee` (`&`), `right_contraction`, `scalar_product`, `commutator`, `sandwich`, `dual`,
/// `undual`. Braces list several types in one line. `blade` before a type says that the operand is
/// an outer product of vectors, as in [`ga!`](crate::ga#operands-that-are-blades). The result is
/// stated with `->`, where `Self` is the type of the last operand and `Scalar` a plain number, or
/// left out where exactly one declared type without facts has just the blades of the result. That
/// each result lies in its type is verified when the macro runs, by exact evaluation at random
/// points. Where no result is stated, products that are always zero are left out:
/// `wedge({Vector, Bivector}, {Vector, Bivector});` declares those that are not, and the compiler
/// warns of a line of which nothing is left.
///
/// Warnings come as the use of a deprecated constant `DECLARATION`, since macros have no warnings
/// of their own; `#[allow(deprecated)]` on the module silences them.
///
/// # What every type has
///
/// - `coefficients()`, an iterator of (name, value); `coefficient_of("e12")`; `is_finite()`.
/// - For a type by parameters, the coefficients of its blades follow from these.
/// - `Display`, as `1 + 2 e12`, and `FromStr` for the same text, with an error that names the term
///   and its place.
/// - `+`, `-`, `*` and `/` by a number, negation; `+=`, `-=`, `*=`, `/=` and `Sum` where the result
///   is of the same type; `Product` for types with 1. A number is added to types whose hull has a
///   scalar. `2.0 * x` and `2.0 + x` are there for `f32` and `f64`.
/// - Operators on references for types of one grade with two to four stored coefficients, and for
///   unit versors with two to eight.
/// - `norm_squared()`, with its sign on the page, and `normalized()`, where the norm is not zero
///   for all members.
/// - `TryFrom` the hull, the smallest and the largest type of more blades, and wider unit versors,
///   up to rounding; `try_from_element(element, tolerance)` from any type.
/// - The constants `ZERO`, `ONE` or `IDENTITY`, and those of basis vectors in types of vectors.
///
/// # The macro of the algebra
///
/// Besides the module, a macro of the same name is emitted, which passes the definition to macros
/// such as [`ga!`](crate::ga) and `ga_runtime::testing::product_tests!`. `crate = path;` before the
/// basis gives the path of ga-runtime in the emitted code, if it is not that of this macro.
///
/// # Limits
///
/// An algebra has at most 128 types and 8192 products. The squares of the types' numbers of blades
/// have at most the sum 131,072, that of two types of 256 blades, and all products together at most
/// 131,072 terms, twice as many as the geometric product of two multivectors of eight dimensions.
/// The coefficient of a blade nests at most 128 levels deep and has at most 1024 operators. Basis
/// vectors, blades and types cannot be named like a keyword of Rust, since fields cannot.
#[macro_export]
macro_rules! algebra {
    ($($declaration:tt)*) => {
        $crate::__private::macros::algebra! { [$crate] $($declaration)* }
    };
}

/// Compiles functions written in an algebra, each as one piece.
///
/// Formulas are written as in a textbook and become straight-line code: only the coefficients of
/// the result are computed, constants are folded, common parts are shared, and facts such as the
/// unit norm of a motor and the null square of a point are used. Before the code is emitted it is
/// checked against the plain meaning of the formula, exactly.
///
/// ```
/// use ga_runtime::cga3::{Motor, Plane, Point, Rotor};
/// use ga_runtime::ga;
///
/// ga! { ga_runtime::cga3;
///     /// The point moved: 21 multiplications and 18 additions.
///     pub fn moved(m: Motor, p: Point) -> Point { m * p * reverse(m) }
///
///     /// The plane through three points, and its distance from a fourth point times the length of
///     /// the cross product of the triangle's edges.
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
/// by name, `Scalar`, arrays `[Point; 3]` and tuples. A body is any number of `let` statements,
/// with patterns, and the formula of the result. Functions of one block may call each other, and
/// those of another block with `use path::of::function;` or `use path::of::{one, other as name};`
/// at the start. A call is compiled as if the body of the function stood in its place, so functions
/// cannot call themselves. A closure, `ga! { cga3; |p: Point, q: Point| -> Scalar { p | q } }`, is
/// an expression.
///
/// | written | means |
/// | --- | --- |
/// | `a * b`, `geometric(a, b)` | geometric product |
/// | `a ^ b`, `wedge(a, b)` | outer product |
/// | <code>a &#124; b</code>, `left_contraction(a, b)` | left contraction |
/// | `a & b`, `vee(a, b)` | regressive product |
/// | `right_contraction`, `scalar_product`, `commutator` | the other products |
/// | `a + b`, `a - b`, `-a`, `a / x` | sum, difference, negative, quotient by a scalar |
/// | `reverse` or `rev`, `involute`, `conjugate` | involutions |
/// | `dual`, `undual`, `grade(a, 2)` | duals, the part of a grade |
/// | `sandwich(m, x)` or `transform` | `m x ~m`; `m x̂ ~m` for an m that is always odd |
/// | `norm_squared`, `norm`, `normalize` | `⟨a ~a⟩₀`, its root, `a` with norm 1 |
/// | `inverse` or `inv` | `~a/(a ~a)` |
/// | `exp` | of scalars, and of bivectors B where B² is a scalar plus a null part |
/// | `log` | of scalars, and of even unit versors that are such an `exp` |
/// | `sqrt`, `abs`, `hypot(x, y)`, `ln`, `recip` | of scalars |
/// | `recip_or_zero` | `1/x`, and 0 for x = 0; `x * recip_or_zero(x)` is taken for 1 |
/// | `sin`, `cos`, `tan`, `asin`, `acos`, `atan2(y, x)` | of scalars, angles in radians |
/// | `sinh`, `cosh`, `tanh` | of scalars |
/// | `pow(x, 3)`, `pow(x, -2)`, `pow(x, 1/2)` | power with a number as exponent |
/// | `point(x)` | where a vector, a flat point or a round is |
/// | `endpoints(x)` | the two points of a point pair, as a tuple |
/// | `min(x, y)`, `max(x, y)`, `clamp(x, low, high)`, `sign(x)` | of scalars |
/// | `select(condition, a, b)` | a where the condition holds, else b |
/// | `<`, `<=`, `>`, `>=`, `==`, `!=` | conditions from two scalars |
/// | `!c`, `c && d`, <code>c &#124;&#124; d</code> | conditions from conditions |
/// | `2`, `0.5`, `pi`, `e12`, `Infinity` | exact numbers, π, basis blades, constant types |
/// | `a.e12`, `s.centre` | a coefficient, a parameter |
/// | `xs[0]`, `t.1` | an element of an array or a tuple |
///
/// Each operation is a function and a method: `reverse(m)` is `m.reverse()`. Precedence is that of
/// Rust, where `^ & |` bind looser than `+ - * /`; a mix of both without parentheses is an error
/// that shows both readings. A formula nests at most 128 levels deep (parentheses, calls, methods
/// and signs) and has at most 1024 operators in a row; `let` splits a longer one.
///
/// # Powers
///
/// `x^2` would be the outer product of x and 2, which of a scalar is `2 x`. So the outer product,
/// the contractions and the regressive product of two scalars are errors; a square is `x * x` or
/// `pow(x, 2)`.
///
/// The exponent of `pow` is a number as it is written, from −1024 to 1024. Of a scalar it may be a
/// fraction: where the denominator is 2, 4, 8 or 16, the power is a product of square roots, else
/// `exp(y ln x)`, which is NaN for negative x, as roots are, and whose relative error grows with
/// `|y ln x|`. A natural number multiplies any multivector with itself, by squaring, and a negative
/// integer multiplies the inverse of a blade or versor. A variable exponent is written
/// `exp(y * ln(x))`; a fraction t of a motion m `exp(t * log(m))`.
///
/// ```
/// ga_runtime::ga! { ga_runtime::cga3;
///     /// The third side of a triangle, by the law of cosines.
///     fn third(a: Scalar, b: Scalar, angle: Scalar) -> Scalar {
///         sqrt(pow(a, 2) + pow(b, 2) - 2*a*b*cos(angle))
///     }
/// }
/// # fn main() {
/// assert!((third(3.0, 4.0, std::f64::consts::FRAC_PI_2) - 5.0).abs() < 1e-15);
/// # }
/// ```
///
/// # Operands that are blades
///
/// The types of cga3 for lines, bivectors and trivectors hold any sum of their blades, so that sums
/// and coefficients need no checks. An operand marked `blade` is taken to be an outer product of
/// vectors, as figures built from points are: the caller makes sure of that. What follows from the
/// Plücker relations is then known, here that a circle C, held as a trivector, has a scalar `C ~C`.
/// Types by parameters, such as `Circle`, need no mark.
///
/// ```
/// use ga_runtime::cga3::{Circle, Point, Trivector};
///
/// ga_runtime::ga! { ga_runtime::cga3;
///     fn inverse_of(blade c: Trivector) -> Trivector { inverse(c) }
/// }
///
/// # fn main() {
/// let points = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [-1.0, 0.0, 0.0]].map(Point::from);
/// let circle: Circle<f64> = points[0] ^ points[1] ^ points[2];
/// let circle = Trivector::from(circle);
/// assert_eq!(inverse_of(inverse_of(circle)), circle);
/// # }
/// ```
///
/// In a call from another function, the argument must be known to be a blade. An algebra of your
/// own can say it in a type, by `#[facts(blade)]`. Where a result of a type by parameters is one
/// only for blades, operands that are flats are taken for blades without a mark: `line & sphere` is
/// a `PointPair`.
///
/// # Conditions
///
/// A formula does not branch, so that lanes of numbers can run it. `select(condition, a, b)`
/// computes both a and b and chooses one of them; what is not chosen may be infinite or NaN. Both
/// may be multivectors, which are chosen blade by blade, or tuples or arrays of the same shape. The
/// result is a `Point`, for instance, if both are.
///
/// ```
/// use ga_runtime::cga3::Point;
/// use ga_runtime::scalar::Lanes;
///
/// ga_runtime::ga! { ga_runtime::cga3;
///     /// Of two points the one that is nearer to a third, which is the one with the larger inner
///     /// product: o · p = −½ |p − o|².
///     fn nearer(o: Point, p: Point, q: Point) -> Point { select((o | p) > (o | q), p, q) }
///     /// The square root, or zero for a negative number.
///     fn root_or_zero(x: Scalar) -> Scalar { select(x < 0, 0, sqrt(x)) }
/// }
///
/// # fn main() {
/// let [o, p, q] = [[0.0; 3], [1.0, 2.0, 2.0], [2.0, 0.0, 0.0]].map(Point::from);
/// assert_eq!(nearer(o, p, q), q);
/// assert_eq!(root_or_zero(Lanes::from_array([4.0, -4.0])).to_array(), [2.0, 0.0]);
/// # }
/// ```
///
/// Conditions can be bound by `let`, but they are neither operands nor results. They need
/// [`Real`](crate::scalar::Real). As in Rust, a comparison with NaN does not hold, except `!=`.
/// `sign` is 0 at 0 and NaN at NaN; `min` and `max` give their first operand where either is
/// NaN.
///
/// While the function is checked, a comparison holds or does not hold whatever the numbers are, so
/// that `x < y && y < x` may hold. The check looks at each pair of comparisons in every combination
/// (up to 48 points), at both outcomes of every `&&`, `||` and `!`, and at the branches of a
/// `select` within the operands of another (up to 64 of each, and 64 points in all). Functions with
/// conditions, `min` or `max` are compiled as they are written; no equivalent formula is tried.
///
/// # Places
///
/// `point(x)` and `endpoints(x)` give points of the conformal model. They work in every algebra
/// that declares a type of points: null vectors P without facts to be checked, such as
/// `struct Point { e1, e2, e3, eo = 1, ei = (e1*e1 + e2*e2 + e3*e3)/2 }`. Names, weights and the
/// basis do not matter: infinity is the null vector N with `P·N = 1` for all points, `-ei` in cga3,
/// and the origin O is the point whose stored coefficients are zero.
///
/// | x | `point(x)` |
/// | --- | --- |
/// | a point | itself, without a division |
/// | a vector v: a weighted point, a dual sphere | `u − ½ u² N` with `u = v/(v·N)` |
/// | a flat point `P∧N` | the same with `v = O⌋x` |
/// | a sphere, the dual of a vector | the same with v its dual: the centre |
/// | a circle, a point pair, a round of any grade | the same with `v = ⟨x N ~x⟩₁`: the centre |
///
/// `endpoints(x)` of `x = w a∧b` with `w > 0` is `(a, b)`, and for `w < 0` it is `(b, a)`:
/// `(x⌊m ∓ √⟨x²⟩₀ m)/m²` with `m = N⌋x`.
///
/// ```
/// use ga_runtime::cga3::{Infinity, Point, Sphere};
///
/// ga_runtime::ga! { ga_runtime::cga3;
///     fn through(a: Point, b: Point, e: Plane) -> Point { point((a ^ b ^ ei) & e) }
///     fn ends(l: Line, s: Sphere) -> (Point, Point) { endpoints(l & s) }
/// }
///
/// # fn main() {
/// let places = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
/// let [o, x, y, z] = places.map(Point::from);
/// let hit = through(Point::new(2.0, 3.0, 4.0), Point::new(2.0, 3.0, 1.0), o ^ x ^ y ^ Infinity);
/// assert_eq!(hit.coordinates(), [2.0, 3.0, 0.0]);
///
/// let sphere = Sphere::from_centre_radius_squared(Point::new(0.0, 0.0, 5.0), 4.0);
/// let (leaves, enters) = ends(o ^ z ^ Infinity, sphere);
/// assert_eq!((enters.e3(), leaves.e3()), (3.0, 7.0));
/// # }
/// ```
///
/// There is one division, by the weight. Where it is zero for particular values, the result is not
/// finite: a dual plane and a direction are at infinity. What is always there, such as a `Plane` or
/// a `Line`, is an error. `endpoints` of an imaginary pair, where a line misses a sphere, is NaN;
/// the two ends of a tangent are the same. Bivectors and trivectors that are not blades are read by
/// the same formulas. A round that stores its centre needs no division.
///
/// # Types of results
///
/// A result is returned as a `Point` only if it is one, of weight 1 and null; otherwise an error
/// says what was found, and whether a division by the weight would help. `let x: Line = …` checks
/// an intermediate value.
///
/// A product that is zero for all operands, though the operands are not, is probably a mistake:
/// `sphere | point` for `point | sphere`, or `line ^ ei`. The compiler warns of it, and of a result
/// that is always zero, as the use of a deprecated constant `ALWAYS_ZERO`, since macros have no
/// warnings of their own. `#[allow(deprecated)]` on the function silences that.
///
/// Divisions by zero and roots of negative numbers give what the scalar gives: infinities or NaN
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
///     /// Two reflections; only the needed part of the intermediate point is computed.
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
/// operands alone and returns a struct, named as the function in camel case, that holds everything
/// computed from them; its method `apply` takes the other operands. `map` changes the scalar, to
/// lanes for instance.
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
///
/// A function that is linear in what varies becomes a matrix, whatever chain of actions, duals and
/// projections it is made of.
///
/// # What a single call costs
///
/// A motor that moves one point, where the compiler can see neither, takes 2.0 (built for the
/// processor at hand) to 2.9 times (default flags) as long as a product of glam's `Mat4` with the
/// point, since glam keeps each column in one vector register. To move many points, mark the motor
/// `uniform`, call the functions of `batch`, or convert the motor by `to_matrix` once.
///
/// A loop over records of an odd number of coefficients, such as three points, may be slower if it
/// is built for a processor with AVX-512, or is [`WIDE`](crate::batch::Work::WIDE) on one: LLVM
/// then reads and writes them by gathers and scatters.
/// The flags `-C target-feature=+prefer-no-gather,+prefer-no-scatter` avoid these (2.6 ns instead
/// of 7 for the circle through three points in `f32`).
#[macro_export]
macro_rules! ga {
    ($($path:ident)::+ ; $($functions:tt)*) => {
        $($path)::+ ! { [$crate::__private::macros::functions] [$($path)::+] $($functions)* }
    };
    (:: $($path:ident)::+ ; $($functions:tt)*) => {
        :: $($path)::+ ! { [$crate::__private::macros::functions] [:: $($path)::+] $($functions)* }
    };
    ($($other:tt)*) => {
        ::core::compile_error! {
            "`ga!` starts with the path of an algebra and `;`, as in \
             `ga! { ga_runtime::cga3; fn inner(p: Point, q: Point) -> Scalar { p | q } }`"
        }
    };
}
