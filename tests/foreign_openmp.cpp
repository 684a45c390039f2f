// Stands for another OpenMP library in the process of a test: what oneDNN asks of it, and no more.
static thread_local int threads = 4;
extern "C" int omp_get_max_threads() { return threads; }
extern "C" void omp_set_num_threads(int count) { threads = count; }
