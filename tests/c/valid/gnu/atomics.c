/* Atomic builtins, <stdatomic.h>, barriers, and locks in a program with a single thread. */
#include <stdio.h>
#include <stdatomic.h>
#include <pthread.h>
#include <stdbool.h>
static atomic_int n = ATOMIC_VAR_INIT(3);
static _Atomic long l;
static atomic_flag fl = ATOMIC_FLAG_INIT;
_Atomic(int *) ap;
atomic_bool ab;
static pthread_mutex_t m = PTHREAD_MUTEX_INITIALIZER;
static pthread_once_t once = PTHREAD_ONCE_INIT;
static void init(void) {
    puts("once");
}

int main(void) {
    int v = 5, w = 9;
    __asm__ volatile("" ::: "memory");
    asm volatile ("" : "+r"(v));
    __asm__ __volatile__("" : : "r"(v), "m"(w) : "memory");
    asm("");
    __asm__("" : "=r"(w) : "0"(v));
    printf("%d\n", w);
    asm goto ("" : : : : done);
    puts("after");
    done:
    printf("%d %d %d\n", __sync_fetch_and_add(&v, 2), __sync_add_and_fetch(&v, 2), v);
    printf("%d %d\n", __sync_bool_compare_and_swap(&v, 9, 1), v);
    printf("%d %d\n", __sync_val_compare_and_swap(&v, 1, 7), v);
    printf("%d\n", __sync_lock_test_and_set(&v, 1));
    __sync_lock_release(&v);
    printf("%d\n", v);
    __sync_synchronize();
    printf("%d %d %d\n", __sync_fetch_and_or(&v, 6), __sync_fetch_and_and(&v, 3),
        __sync_nand_and_fetch(&v, 2));
    printf("%d %d\n", __sync_xor_and_fetch(&v, 5), __sync_sub_and_fetch(&v, 1));
    short sh = 3;
    printf("%d\n", __sync_add_and_fetch(&sh, 70000));
    int *ip = &v;
    __sync_fetch_and_add(&ip, 4);
    printf("%d\n", (int)(ip - &v));
    __atomic_store_n(&v, 4, __ATOMIC_SEQ_CST);
    printf("%d\n", __atomic_load_n(&v, __ATOMIC_ACQUIRE));
    int e = 4;
    printf("%d\n", __atomic_compare_exchange_n(&v, &e, 8, 0, __ATOMIC_SEQ_CST, __ATOMIC_RELAXED));
    printf("%d %d\n", __atomic_compare_exchange_n(&v, &e, 9, 0, 5, 0), e);
    printf("%d %d %d\n", __atomic_fetch_add(&v, 1, 5), __atomic_add_fetch(&v, 1, 5),
        __atomic_exchange_n(&v, 2, 5));
    int r;
    __atomic_load(&v, &r, 5);
    e = 6;
    __atomic_store(&v, &e, 5);
    __atomic_exchange(&v, &r, &e, 5);
    printf("%d %d %d\n", v, r, e);
    struct {
        int a, b;
    } s1 = {1,2}, s2;
    __atomic_load(&s1, &s2, 5);
    printf("%d\n", s2.b);
    char tas = 0;
    printf("%d %d\n", __atomic_test_and_set(&tas, 5), __atomic_test_and_set(&tas, 5));
    __atomic_clear(&tas, 5);
    printf("%d\n", tas);
    __atomic_thread_fence(5);
    __atomic_signal_fence(5);
    printf("%d %d\n", __atomic_is_lock_free(4, 0), __atomic_always_lock_free(4, 0));
    atomic_init(&l, 4);
    atomic_fetch_add(&l, 3);
    printf("%ld\n", atomic_load(&l));
    n++;
    n += 4;
    printf("%d\n", n);
    atomic_store(&n, 1);
    int ex = 1;
    printf("%d %d\n", atomic_compare_exchange_strong(&n, &ex, 5), n);
    printf("%d\n", atomic_flag_test_and_set(&fl));
    printf("%d\n", atomic_flag_test_and_set_explicit(&fl, memory_order_acquire));
    atomic_flag_clear(&fl);
    printf("%d\n", atomic_exchange_explicit(&n, 3, memory_order_relaxed));
    atomic_thread_fence(memory_order_seq_cst);
    atomic_store(&ab, true);
    printf("%d %d\n", atomic_load(&ab), atomic_is_lock_free(&n));
    atomic_store(&ap, &v);
    printf("%d\n", *atomic_load(&ap));
    printf("%d\n", (int) kill_dependency(5));
    int ar[3] = {1,2,3};
    atomic_store(&ap, ar);
    atomic_fetch_add(&ap, 1);
    printf("%d %d\n", atomic_fetch_or(&n, 8), atomic_fetch_xor(&n, 1));
    pthread_once(&once, init);
    pthread_once(&once, init);
    pthread_mutex_lock(&m);
    printf("%d\n", pthread_mutex_trylock(&m) != 0);
    pthread_mutex_unlock(&m);
    pthread_mutex_t m2;
    pthread_mutex_init(&m2, 0);
    pthread_mutex_destroy(&m2);
    printf("%d\n", pthread_equal(pthread_self(), pthread_self()));
    return 0;
}
