/* Packed structs, as used for messages and registers. */
#include <stddef.h>
#include <stdio.h>
#include <string.h>

struct __attribute__((packed)) header {
    char kind;
    int length;
    short port;
    double time;
};

typedef struct {
    unsigned char a : 3;
    unsigned int b : 31;
    unsigned long long c : 60;
    signed int d : 5;
} __attribute__((__packed__)) odd_bits;

struct mixed {
    char a;
    int b __attribute__((packed));
    short c;
    struct header inner;
} v = {1, 2, 3, {4, 5, 6, 7.5}};

union either {
    struct header h;
    char raw[20];
} __attribute__((packed));

static odd_bits global = {5, 0x7fffffff, 0x123456789abcdefull, -3};

static void show(const void *data, int size)
{
    const unsigned char *byte = data;
    int i;
    for (i = 0; i < size; i++)
        printf("%02x", byte[i]);
    printf("\n");
}

int main(void)
{
    odd_bits bits;
    struct header h = {'x', 0x01020304, -2, 2.5}, copies[3];

    printf("%u %u %u %u\n", (unsigned)sizeof(struct header), (unsigned)sizeof(odd_bits),
           (unsigned)sizeof(struct mixed), (unsigned)sizeof(union either));
    printf("%u %u %u\n", (unsigned)offsetof(struct header, length),
           (unsigned)offsetof(struct header, time), (unsigned)offsetof(struct mixed, inner.port));
    printf("%d %d\n", (int)__alignof__(struct header), (int)__alignof__(struct mixed));
    show(&h, sizeof h);
    show(&v, sizeof v);
    show(&global, sizeof global);
    memset(&bits, 0, sizeof bits);
    bits.b = 0x55555555;
    bits.c = ~0ull;
    show(&bits, sizeof bits);
    bits.c -= 0x1000000000ull;
    bits.d = 12;
    bits.d--;
    bits.a = bits.b;
    show(&bits, sizeof bits);
    printf("%u %u %llx %d\n", bits.a, bits.b, (unsigned long long)bits.c, bits.d);
    copies[0] = copies[2] = h;
    copies[1].time = copies[2].time * copies[0].length;
    copies[1].length = copies[2].port++;
    printf("%g %d %d\n", copies[1].time, copies[1].length, copies[2].port);
    return 0;
}
