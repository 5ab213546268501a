// Where features lie in `activations`: the last layer's results of each part.

// Of a part in a view; the attributes' features come first, the nodes' follow.
uint features_at(uint view, uint part) {
    return (view * PARTS + part) * ACTIVATIONS + block.layer_results[LAYERS - 1u];
}
