// The key of a splat. The including shader declares `splats`, the splats' buffer as vectors of four
// words.
uint key_at(uint i) {
    uint word = frame.key_start + (frame.half_keys != 0u ? i >> 1u : i);
    uint keys = splats[word >> 2u][word & 3u];
    return frame.half_keys != 0u ? keys >> (16u * (i & 1u)) & 0xffffu : keys;
}
