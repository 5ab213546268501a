//! The `resolve` stage: avatars that were drawn larger than they are shown go in, each in its slot
//! of the atlas; they are averaged and blended into the frame's image. Avatars before what the
//! image holds go over it, the others behind it ([`effigy_core::frame::atlas`]).

use super::{
    super::{
        buffer::empty,
        device::Gpu,
        drawing::TrianglePipeline,
        error::Result,
        frame_in_flight::{FrameInFlight, Writes},
        kernel::{Bindings, Bound},
        owned::Buffer,
    },
    inputs::Draw,
};
use crate::wgsl;
use bytemuck::{Pod, Zeroable, bytes_of};
use effigy_core::frame::{Stage, atlas::AtlasSlot};
use wgpu::{
    BlendComponent, BlendFactor, BlendOperation, BlendState, BufferUsages, LoadOp, Operations,
    ShaderStages, StoreOp, TextureFormat, TextureView,
};

/// What `shaders/resolve` is told of a slot.
#[repr(C)]
#[derive(Clone, Copy, Pod, Zeroable)]
struct SlotBlock {
    /// Column and row in the image of the first pixel that the slot holds.
    shown: [i32; 2],
    /// Column and row in the atlas of its first texel.
    first: [i32; 2],
    /// Texels of the atlas in a pixel, each way.
    factor: f32,
    _padding: [f32; 3],
}

/// Bytes from one slot's block to the next: the largest alignment that a device may ask for.
const STRIDE: u64 = (size_of::<SlotBlock>() as u64).next_multiple_of(256);

/// What a frame averages.
pub struct SlotsFrame<'a> {
    /// What they are averaged into.
    pub image: &'a TextureView,
    /// The draw of the frame's image.
    pub draw: &'a Draw<'a>,
    /// In the order in which they are blended.
    pub slots: &'a [AtlasSlot],
    /// Whether the image holds nothing, and is cleared first.
    pub clear: bool,
}

/// What averages the atlas into the image.
pub struct Resolve {
    /// A [`SlotBlock`] a slot, [`STRIDE`] apart.
    slots: Buffer,
    bindings: Bindings,
    /// Blends a slot over what the image holds.
    over: wgpu::RenderPipeline,
    /// Blends it behind that.
    behind: wgpu::RenderPipeline,
}

impl Resolve {
    /// For at most so many slots of an atlas. `format`: of the image.
    pub fn new(
        gpu: &Gpu,
        atlas: &TextureView,
        format: TextureFormat,
        slots: usize,
    ) -> Result<Self> {
        let usage = BufferUsages::UNIFORM | BufferUsages::COPY_DST;
        let slots = empty(gpu, "slots", slots as u64 * STRIDE, usage)?;
        let bound = bound(atlas, &slots);
        let bindings = Bindings::new(gpu, ShaderStages::FRAGMENT, &bound);
        let pipeline = |blend| {
            let drawing = TrianglePipeline {
                label: Stage::Resolve.name(),
                bindings: &bindings,
                bound: &bound,
                vertex: &wgsl::PRESENT_VERTEX,
                fragment: &wgsl::RESOLVE_FRAGMENT,
                target: wgpu::ColorTargetState {
                    format,
                    blend: Some(blend),
                    write_mask: wgpu::ColorWrites::ALL,
                },
                depth: None,
            };
            drawing.pipeline(gpu)
        };
        Ok(Self {
            // Premultiplied "over": C = c + (1 − α) C.
            over: pipeline(blend(BlendFactor::One, BlendFactor::OneMinusSrcAlpha))?,
            // What is drawn goes behind what is there: C = (1 − A) c + C.
            behind: pipeline(blend(BlendFactor::OneMinusDstAlpha, BlendFactor::One))?,
            bindings,
            slots,
        })
    }

    /// Averages this atlas from now on.
    pub fn set_atlas(&mut self, gpu: &Gpu, atlas: &TextureView) {
        self.bindings.set(gpu, 0, &bound(atlas, &self.slots));
    }

    /// Says where the slots of the next frame are.
    pub fn write(&self, gpu: &Gpu, slots: &[AtlasSlot]) {
        for (index, slot) in slots.iter().enumerate() {
            let block = SlotBlock {
                shown: slot.around.min.into(),
                first: slot.at.as_ivec2().into(),
                factor: slot.factor as f32,
                _padding: [0.0; 3],
            };
            gpu.queue
                .write_buffer(&self.slots, index as u64 * STRIDE, bytes_of(&block));
        }
    }

    /// Averages slots into the damage rectangle of the image. `writes`: its timestamps.
    pub fn record(
        &self,
        in_flight: &FrameInFlight,
        encoder: &mut wgpu::CommandEncoder,
        frame: &SlotsFrame,
        writes: Writes,
    ) {
        let draw = frame.draw;
        let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            label: Some(Stage::Resolve.name()),
            color_attachments: &[Some(wgpu::RenderPassColorAttachment {
                view: frame.image,
                depth_slice: None,
                resolve_target: None,
                ops: Operations {
                    load: if frame.clear {
                        LoadOp::Clear(wgpu::Color::TRANSPARENT)
                    } else {
                        LoadOp::Load
                    },
                    store: StoreOp::Store,
                },
            })],
            timestamp_writes: in_flight.draw_writes(writes),
            ..Default::default()
        });
        for (index, slot) in frame.slots.iter().enumerate() {
            let shown = slot.shown(draw.size).intersection(draw.damage.drawn);
            if shown.is_empty() {
                continue;
            }
            let [min, size] = [shown.min, shown.max - shown.min];
            pass.set_pipeline(if slot.behind {
                &self.behind
            } else {
                &self.over
            });
            self.bindings
                .bind_draw(&mut pass, (index as u64 * STRIDE) as u32);
            pass.set_scissor_rect(min.x, min.y, size.x, size.y);
            pass.draw(0..3, 0..1);
        }
    }
}

fn bound<'a>(atlas: &'a TextureView, slots: &'a wgpu::Buffer) -> [(u32, Bound<'a>); 2] {
    let size = size_of::<SlotBlock>() as u64;
    [(0, Bound::Texture(atlas)), (1, Bound::Block(slots, size))]
}

/// Factors of colour and of coverage alike.
fn blend(src_factor: BlendFactor, dst_factor: BlendFactor) -> BlendState {
    let both = BlendComponent {
        src_factor,
        dst_factor,
        operation: BlendOperation::Add,
    };
    BlendState {
        color: both,
        alpha: both,
    }
}
