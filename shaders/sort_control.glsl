// The mirror of layout::Control.
struct Control {
    uint index_count;
    uint instance_count;
    uint first_index;
    int vertex_offset;
    uint first_instance;
    uint entering;
    uint survivors;
    uint fragments;
};
