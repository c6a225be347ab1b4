#pragma once

namespace unstep::codec {

/// Lets the heap that a new thread got for itself lie in large pages, where the
/// system has them for those who ask (Linux with glibc; elsewhere, and if the
/// thread shares a heap, nothing happens). A page's first touch is a call into
/// the system. At the start of a thread that will code a block.
void prepare_thread_heap();

}  // namespace unstep::codec
