//! The graphics processor, or a software implementation of one.

use wgpu::util::DeviceExt;

use crate::shader::{Shader, WORKGROUP};

/// A device that runs compute shaders.
pub struct Gpu {
    device: wgpu::Device,
    queue: wgpu::Queue,
    /// The name of the adapter.
    pub name: String,
}

impl Gpu {
    /// Any adapter of this machine; `None`, with a message, if there is none.
    #[must_use]
    pub fn find() -> Option<Self> {
        let found = pollster::block_on(async {
            let instance = wgpu::Instance::new(
                wgpu::InstanceDescriptor::new_without_display_handle_from_env(),
            );
            let adapter = instance
                .request_adapter(&wgpu::RequestAdapterOptions::default())
                .await
                .map_err(|error| error.to_string())?;
            let name = adapter.get_info().name;
            let descriptor = wgpu::DeviceDescriptor {
                required_limits: wgpu::Limits::downlevel_defaults(),
                ..Default::default()
            };
            let (device, queue) = adapter
                .request_device(&descriptor)
                .await
                .map_err(|error| format!("{name}: {error}"))?;
            Ok::<_, String>(Self {
                device,
                queue,
                name,
            })
        });
        match found {
            Ok(gpu) => Some(gpu),
            Err(reason) => {
                println!(
                    "skipped: no adapter to run shaders on ({reason}); \
                     Debian's mesa-vulkan-drivers brings one in software"
                );
                None
            }
        }
    }

    /// Runs a shader over elements, each of as many numbers as the shader's input element.
    ///
    /// # Panics
    /// If the device rejects the shader or is lost.
    #[must_use]
    pub fn run(&self, shader: &Shader, elements: &[f32]) -> Vec<f32> {
        let device = &self.device;
        let count = elements.len() / shader.inputs;
        let size = (count * shader.outputs * size_of::<f32>()) as u64;
        let bytes: Vec<u8> = elements.iter().flat_map(|x| x.to_le_bytes()).collect();
        let input = device.create_buffer_init(&wgpu::util::BufferInitDescriptor {
            label: None,
            contents: &bytes,
            usage: wgpu::BufferUsages::STORAGE,
        });
        let buffer = |usage| {
            device.create_buffer(&wgpu::BufferDescriptor {
                label: None,
                size,
                usage,
                mapped_at_creation: false,
            })
        };
        let output = buffer(wgpu::BufferUsages::STORAGE | wgpu::BufferUsages::COPY_SRC);
        let read_back = buffer(wgpu::BufferUsages::MAP_READ | wgpu::BufferUsages::COPY_DST);
        let module = device.create_shader_module(wgpu::ShaderModuleDescriptor {
            label: None,
            source: wgpu::ShaderSource::Wgsl(shader.text.as_str().into()),
        });
        let pipeline = device.create_compute_pipeline(&wgpu::ComputePipelineDescriptor {
            label: None,
            layout: None,
            module: &module,
            entry_point: Some("compute_all"),
            compilation_options: Default::default(),
            cache: None,
        });
        let bind_group = device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: None,
            layout: &pipeline.get_bind_group_layout(0),
            entries: &[
                wgpu::BindGroupEntry {
                    binding: 0,
                    resource: input.as_entire_binding(),
                },
                wgpu::BindGroupEntry {
                    binding: 1,
                    resource: output.as_entire_binding(),
                },
            ],
        });
        let mut encoder = device.create_command_encoder(&Default::default());
        {
            let mut pass = encoder.begin_compute_pass(&Default::default());
            pass.set_pipeline(&pipeline);
            pass.set_bind_group(0, &bind_group, &[]);
            let groups = u32::try_from(count)
                .expect("few elements")
                .div_ceil(WORKGROUP);
            pass.dispatch_workgroups(groups, 1, 1);
        }
        encoder.copy_buffer_to_buffer(&output, 0, &read_back, 0, size);
        self.queue.submit([encoder.finish()]);
        read_back.map_async(wgpu::MapMode::Read, .., |mapped| {
            mapped.expect("a mapped buffer")
        });
        device
            .poll(wgpu::PollType::wait_indefinitely())
            .expect("the shader terminates");
        let view = read_back.get_mapped_range(..).expect("a mapped buffer");
        let (numbers, _) = view.as_chunks::<4>();
        numbers
            .iter()
            .map(|&bytes| f32::from_le_bytes(bytes))
            .collect()
    }
}
