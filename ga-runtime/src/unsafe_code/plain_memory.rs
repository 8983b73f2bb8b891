//! The declared types as plain memory.

/// Marks the declared types as plain memory by the traits of bytemuck. `interop::bytemuck`
/// documents this and lists the types.
macro_rules! plain_memory {
    ($module:ident { $($name:ident $count:literal),* }) => { $(
        // SAFETY: what `algebra!` declares is `repr(C)` with one field of type S for each stored
        // coefficient, so that its size is a multiple of its alignment, which is that of S, and
        // there is no padding. The assertions check the count of the fields. All values of the
        // fields are valid: if a fact is violated, results are wrong, but behaviour is not
        // undefined.
        unsafe impl<S: bytemuck_1::Zeroable> bytemuck_1::Zeroable for crate::$module::$name<S> {}
        // SAFETY: the same.
        unsafe impl<S: bytemuck_1::Pod> bytemuck_1::Pod for crate::$module::$name<S> {}
        const _: () = {
            assert!(size_of::<crate::$module::$name<u8>>() == $count);
            assert!(align_of::<crate::$module::$name<u8>>() == align_of::<u8>());
            assert!(size_of::<crate::$module::$name<f32>>() == $count * size_of::<f32>());
            assert!(align_of::<crate::$module::$name<f32>>() == align_of::<f32>());
            assert!(size_of::<crate::$module::$name<f64>>() == $count * size_of::<f64>());
            assert!(align_of::<crate::$module::$name<f64>>() == align_of::<f64>());
        };
    )* };
}

crate::interop::bytemuck::declared_types!(plain_memory);
