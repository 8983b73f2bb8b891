//! What every declared type has beside its products. `algebra!` describes its types to this macro,
//! by entries in braces: `{ linear Line } { normalized Line [e1oi e2oi e3oi] [e12i …] }`.
//!
//! The code is here and not in the compiler, since each emitted token costs time in the build. The
//! names of type parameters end in an underscore, since a type may be called `T` or `Rhs`.

/// Emits the methods and traits of each entry.
#[doc(hidden)]
#[macro_export]
macro_rules! __surface {
    ($({ $($entry:tt)* })*) => { $( $crate::__surface_entry! { $($entry)* } )* };
}

/// Emits the methods and traits of one entry.
#[doc(hidden)]
#[macro_export]
macro_rules! __surface_entry {
    // Its coefficients, by the trait that its `Element` requires of the scalar.
    (element $name:ident $graded:ident $bound:ident) => {
        impl<S: $crate::scalar::$bound> $name<S> {
            /// The coefficients of all blades of the type with their names.
            #[inline]
            pub fn coefficients(self) -> $crate::Coefficients<Self> {
                $crate::Element::coefficients(self)
            }
            /// The coefficient of the blade of that name; `None` where the type has no such blade.
            #[inline]
            #[must_use]
            pub fn coefficient_of(self, name: &::core::primitive::str) -> ::core::option::Option<S> {
                $crate::Element::coefficient_of(self, name)
            }
            /// The part of one grade; zero where the type has no blade of it.
            #[inline]
            #[must_use]
            pub fn grade(self, grade: ::core::primitive::usize) -> $graded<S> {
                $crate::__private::grade(self, grade)
            }
            /// Whether every coefficient is neither infinite nor NaN; for lanes, one mask entry per
            /// lane.
            #[inline]
            #[must_use]
            pub fn is_finite(self) -> <S as $crate::scalar::Select>::Mask
            where
                S: $crate::scalar::Real,
            {
                $crate::Element::is_finite(self)
            }
            /// The member of this type that another element is, up to a tolerance relative to its
            /// largest coefficient.
            ///
            /// # Errors
            /// `ga_runtime::NotMember` with the coefficient that is different.
            #[inline]
            pub fn try_from_element<U: $crate::Element<Scalar = S>>(
                element: U,
                tolerance: S,
            ) -> ::core::result::Result<Self, $crate::NotMember>
            where
                S: $crate::scalar::Real<Mask = ::core::primitive::bool>,
            {
                $crate::Element::try_from_element(element, tolerance)
            }
        }
        impl<S: $crate::scalar::Real> $crate::scalar::Select for $name<S> {
            type Mask = <S as $crate::scalar::Select>::Mask;
            #[inline]
            fn select(mask: Self::Mask, if_true: Self, if_false: Self) -> Self {
                $crate::__private::select(mask, if_true, if_false)
            }
        }
        impl<S: $crate::scalar::$bound + ::core::fmt::Display> ::core::fmt::Display for $name<S> {
            fn fmt(&self, f: &mut ::core::fmt::Formatter<'_>) -> ::core::fmt::Result {
                $crate::__private::write(*self, f)
            }
        }
        impl<S> ::core::str::FromStr for $name<S>
        where
            S: $crate::scalar::Real<Mask = ::core::primitive::bool> + ::core::str::FromStr,
        {
            type Err = $crate::ParseElementError;
            fn from_str(text: &::core::primitive::str) -> ::core::result::Result<Self, Self::Err> {
                $crate::__private::parse(text)
            }
        }
    };
    // A type of which sums and multiples are members.
    (linear $name:ident) => {
        impl<S: $crate::scalar::Ring, Rhs_> ::core::ops::AddAssign<Rhs_> for $name<S>
        where
            Self: ::core::ops::Add<Rhs_, Output = Self>,
        {
            #[inline]
            fn add_assign(&mut self, other: Rhs_) { *self = *self + other; }
        }
        impl<S: $crate::scalar::Ring, Rhs_> ::core::ops::SubAssign<Rhs_> for $name<S>
        where
            Self: ::core::ops::Sub<Rhs_, Output = Self>,
        {
            #[inline]
            fn sub_assign(&mut self, other: Rhs_) { *self = *self - other; }
        }
        impl<S: $crate::scalar::Ring, Rhs_> ::core::ops::DivAssign<Rhs_> for $name<S>
        where
            Self: ::core::ops::Div<Rhs_, Output = Self>,
        {
            #[inline]
            fn div_assign(&mut self, other: Rhs_) { *self = *self / other; }
        }
        /// Of elements that convert to this type without loss.
        impl<S: $crate::scalar::Ring, Item_> ::core::iter::Sum<Item_> for $name<S>
        where
            Item_: ::core::convert::Into<Self>,
        {
            fn sum<I_: ::core::iter::Iterator<Item = Item_>>(items: I_) -> Self {
                items.fold(<Self as ::core::default::Default>::default(), |sum, item| {
                    sum + ::core::convert::Into::into(item)
                })
            }
        }
        impl<'a, S: $crate::scalar::Ring> ::core::iter::Sum<&'a $name<S>> for $name<S> {
            fn sum<I_: ::core::iter::Iterator<Item = &'a Self>>(items: I_) -> Self {
                ::core::iter::Iterator::sum(::core::iter::Iterator::copied(items))
            }
        }
        $crate::__surface_entry! { multiplied $name }
    };
    // A type of which products with some other type are members.
    (multiplied $name:ident) => {
        impl<S: $crate::scalar::Ring, Rhs_> ::core::ops::MulAssign<Rhs_> for $name<S>
        where
            Self: ::core::ops::Mul<Rhs_, Output = Self>,
        {
            #[inline]
            fn mul_assign(&mut self, other: Rhs_) { *self = *self * other; }
        }
    };
    // A type with 1 and the products of its members.
    (product $name:ident) => {
        /// Of elements that convert to this type without loss, the first as the left factor.
        impl<S: $crate::scalar::Ring, Item_> ::core::iter::Product<Item_> for $name<S>
        where
            Item_: ::core::convert::Into<Self>,
            Self: ::core::ops::Mul<Output = Self> + $crate::Element<Scalar = S>,
        {
            fn product<I_: ::core::iter::Iterator<Item = Item_>>(items: I_) -> Self {
                items.fold($crate::__private::one(), |product, item| {
                    product * ::core::convert::Into::<Self>::into(item)
                })
            }
        }
        impl<'a, S: $crate::scalar::Ring> ::core::iter::Product<&'a $name<S>> for $name<S>
        where
            Self: ::core::ops::Mul<Output = Self> + $crate::Element<Scalar = S>,
        {
            fn product<I_: ::core::iter::Iterator<Item = &'a Self>>(items: I_) -> Self {
                ::core::iter::Iterator::product(::core::iter::Iterator::copied(items))
            }
        }
    };
    // The element of norm 1, with the coefficients on which the norm depends.
    (normalized $name:ident [$($measured:ident)*] [$($field:ident)*]) => {
        impl<S: $crate::scalar::Real> $name<S> {
            /// The multiple `x/√|n|` of this element with [`norm_squared`](Self::norm_squared) 1 or
            /// −1, the sign of `n = ⟨x ~x⟩₀`; `None` where n is zero, or a coefficient is not
            /// finite. Large and small elements lose nothing.
            #[inline]
            #[must_use]
            pub fn normalized(self) -> $crate::scalar::Maybe<Self, S> {
                let divided = |element: Self, divisor: S| Self {
                    $($field: element.$field / divisor),*
                };
                let scaled = $crate::__private::scaled_norm(
                    self, Self::norm_squared, [$(self.$measured),*], divided,
                );
                $crate::scalar::Optional::and_then(scaled, |(element, size)| {
                    let unit = divided(element, $crate::scalar::Real::sqrt(size));
                    let is_finite = $($crate::scalar::Real::is_finite(unit.$field))&*;
                    $crate::scalar::Mask::when(is_finite, unit)
                })
            }
        }
    };
    // The multiple of norm 1 of a type that is not stored as coefficients.
    (unit_multiple $name:ident) => {
        impl<S: $crate::scalar::Real> $name<S> {
            /// The multiple `x/√|n|` of this element with [`norm_squared`](Self::norm_squared) 1 or
            /// −1, the sign of `n = ⟨x ~x⟩₀`; `None` where n is zero, or a coefficient is not
            /// finite. Large and small elements lose nothing.
            #[inline]
            #[must_use]
            pub fn normalized(self) -> $crate::scalar::Maybe<Self, S> {
                $crate::scalar::Optional::and_then($crate::__private::largest(self), |size| {
                    let element = self / size;
                    let size = $crate::scalar::Real::abs(element.norm_squared());
                    let unit = element / $crate::scalar::Real::sqrt(size);
                    let has_size = $crate::scalar::Real::less_than(S::zero(), size);
                    let is_finite = <Self as $crate::Element>::is_finite(unit);
                    $crate::scalar::Mask::when(has_size & is_finite, unit)
                })
            }
        }
    };
    // A unit versor that rounding may have changed.
    (renormalized $name:ident) => {
        impl<S: $crate::scalar::Real> $name<S> {
            /// The nearest unit versor, which removes the rounding errors of a long product; `None`
            /// where a coefficient is not finite.
            #[inline]
            #[must_use]
            pub fn normalized(self) -> $crate::scalar::Maybe<Self, S> {
                Self::normalize(::core::convert::From::from(self))
            }
        }
    };
    // A unit versor whatever its coefficients.
    (always_unit $name:ident) => {
        impl<S: $crate::scalar::Real> $name<S> {
            /// The same versor, which has norm 1 whatever its coefficients are; `None` where one of
            /// them is not finite.
            #[inline]
            #[must_use]
            pub fn normalized(self) -> $crate::scalar::Maybe<Self, S> {
                $crate::scalar::Mask::when(<Self as $crate::Element>::is_finite(self), self)
            }
        }
    };
    // A type some of whose elements are members of another.
    (try_from $source:ident $name:ident) => {
        /// Up to a tolerance of 1024 ε relative to the largest coefficient; for another one:
        /// [`try_from_element`](Self::try_from_element).
        impl<S> ::core::convert::TryFrom<$source<S>> for $name<S>
        where
            S: $crate::scalar::Real<Mask = ::core::primitive::bool>,
        {
            type Error = $crate::NotMember;
            fn try_from(element: $source<S>) -> ::core::result::Result<Self, Self::Error> {
                $crate::Element::try_from_element(element, $crate::__private::default_tolerance())
            }
        }
    };
    // The sum of a number and an element, in a type with a scalar.
    (with_scalar $name:ident $hull:ident $scalar:ident $bound:ident) => {
        impl<S: $crate::scalar::$bound> ::core::ops::Add<S> for $name<S> {
            type Output = $hull<S>;
            #[inline]
            fn add(self, scalar: S) -> Self::Output {
                let mut sum: $hull<S> = ::core::convert::From::from(self);
                sum.$scalar += scalar;
                sum
            }
        }
        impl<S: $crate::scalar::$bound> ::core::ops::Sub<S> for $name<S> {
            type Output = $hull<S>;
            #[inline]
            fn sub(self, scalar: S) -> Self::Output {
                let mut sum: $hull<S> = ::core::convert::From::from(self);
                sum.$scalar -= scalar;
                sum
            }
        }
    };
    // The same with the number on the left.
    (number_and $name:ident $hull:ident) => {
        $crate::__surface_entry! { number_and $name $hull f32 }
        $crate::__surface_entry! { number_and $name $hull f64 }
    };
    (number_and $name:ident $hull:ident $number:ident) => {
        impl ::core::ops::Add<$name<::core::primitive::$number>> for ::core::primitive::$number {
            type Output = $hull<::core::primitive::$number>;
            #[inline]
            fn add(self, element: $name<::core::primitive::$number>) -> Self::Output {
                element + self
            }
        }
        impl ::core::ops::Sub<$name<::core::primitive::$number>> for ::core::primitive::$number {
            type Output = $hull<::core::primitive::$number>;
            #[inline]
            fn sub(self, element: $name<::core::primitive::$number>) -> Self::Output {
                -element + self
            }
        }
    };
    // The element 1.
    (one $name:ident $constant:ident [$($field:ident $value:ident)*]) => {
        impl<S: $crate::scalar::ConstRing> $name<S> {
            /// The element 1.
            pub const $constant: Self = Self { $($field: S::$value),* };
        }
    };
    // Zero and the basis vectors.
    (zero $name:ident [$($field:ident)*] [$($vector:ident $constant:ident)*]) => {
        impl<S: $crate::scalar::ConstRing> $name<S> {
            /// Zero.
            pub const ZERO: Self = Self { $($field: S::ZERO),* };
            $(
                #[doc = ::core::concat!("The basis vector ", ::core::stringify!($vector), ".")]
                pub const $constant: Self = Self { $vector: S::ONE, ..Self::ZERO };
            )*
        }
    };
    // Operators on references to a type, whatever they are applied to.
    (references $name:ident [$($trait:ident $method:ident)*]) => { $(
        impl<'a, S: ::core::marker::Copy, Rhs_> ::core::ops::$trait<Rhs_> for &'a $name<S>
        where
            $name<S>: ::core::ops::$trait<Rhs_>,
        {
            type Output = <$name<S> as ::core::ops::$trait<Rhs_>>::Output;
            #[inline]
            fn $method(self, other: Rhs_) -> Self::Output {
                ::core::ops::$trait::$method(*self, other)
            }
        } )*
        impl<'a, S: ::core::marker::Copy> ::core::ops::Neg for &'a $name<S>
        where
            $name<S>: ::core::ops::Neg,
        {
            type Output = <$name<S> as ::core::ops::Neg>::Output;
            #[inline]
            fn neg(self) -> Self::Output {
                ::core::ops::Neg::neg(*self)
            }
        }
    };
    // An operator whose right operand is a reference.
    (reference_to $right:ident $($left:ident $trait:ident $method:ident)*) => { $(
        impl<'a, S: ::core::marker::Copy> ::core::ops::$trait<&'a $right<S>> for $left<S>
        where
            $left<S>: ::core::ops::$trait<$right<S>>,
        {
            type Output = <$left<S> as ::core::ops::$trait<$right<S>>>::Output;
            #[inline]
            fn $method(self, other: &'a $right<S>) -> Self::Output {
                ::core::ops::$trait::$method(self, *other)
            }
        } )*
    };
}
