// The mirror of layout::Control: what the sort writes and the draw reads.
struct Control {
    uint index_count;
    uint instance_count;
    uint first_index;
    int vertex_offset;
    uint first_instance;
    uint key_count;
    uint visible_count;
    uint fragments;
};
