/* Additions of C23: keywords, attributes, constexpr, auto, empty initialisers, and more. */
// without gcc: gcc 12 has only half of C23
// gcc options: -std=c23
#include <stdio.h>
#include <stddef.h>
constexpr int N = 5;
constexpr double D = 2.5;
static_assert(N == 5);
static_assert(sizeof(int) == 4, "x");
[[nodiscard]] int f(int, [[maybe_unused]] char *) {
    return 3;
}

[[deprecated("old")]] static int g(int a) {
    return a;
}

struct [[gnu::packed]] P {
    char c;
    int i;
};
enum small : unsigned char {
    S1, S2
};
int arr[N] = {};
struct q {
    int a, b[3];
};
[[noreturn]] void stop(void);
typeof(int *) tp;
typeof_unqual(const int) tq = 3;
int old();
#define HAS(...) __VA_OPT__(1 +) 0

int main(void) {
    bool b = true;
    auto x = 3.5;
    int *p = nullptr;
    if (p == nullptr && b != false) puts("null");
    printf("%d %d %d\n", 1'000'000, 0b1010'1010, 0x1'FF);
    printf("%b %#b %08b\n", 10u, 5u, 3u);
    typeof(x) y = x * 2;
    printf("%g\n", y);
    struct q z = {};
    printf("%d %d\n", z.a, z.b[2]);
    int e = {};
    printf("%d\n", e);
    auto s = "text";
    static auto kept = 2.5f;
    printf("%g %d\n", kept, (int) sizeof kept);
    int bits = 0;
    sscanf("1012", "%b", &bits);
    printf("%d\n", bits);
    printf("%s %g %d\n", s, D, f(1, 0));
    switch (N) {
        case 5:
        int dd = 4;
        printf("%d\n", dd);
        [[fallthrough]];
        case 6:
        default:
    }
    goto end;
    end:
    int after = 3;
    printf("%d\n", after);
    {
        lab:
    }
    printf("%d %d\n", (int) sizeof(struct P), (int) sizeof(enum small));
#ifdef NOPE
#elifdef N2
#elifndef N2
    puts("elifndef");
#endif
    printf("%d\n", (int) sizeof(true));
    alignas(32) char al[3];
    printf("%d %d\n", (int) alignof(int), (int)((size_t) al % 32));
    thread_local static int tl = 4;
    printf("%d\n", tl);
    constexpr int loc = N * 2;
    static int st = loc;
    printf("%d\n", st);
    [[maybe_unused]] int un;
    nullptr_t np = nullptr;
    printf("%d\n", np == 0);
    printf("%d\n", (int)(sizeof(nullptr) == sizeof(void*)));
    int vs[] = { [0 ... 2] = 7 };
    printf("%d\n", vs[2]);
    unreachable_test:
    ;
    printf("%d\n", HAS(a));
    printf("%s\n", _Generic(nullptr, nullptr_t: "np", default: "no"));
    printf("%ld\n", __STDC_VERSION__ > 201710L);
    return 0;
}
