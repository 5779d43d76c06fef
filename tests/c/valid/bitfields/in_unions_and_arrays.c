/* Bit-fields seen as bytes, in unions, in arrays of structs, copied and passed. */
#include <stdio.h>
#include <string.h>

union word {
    unsigned all;
    struct { unsigned low : 8, middle : 16, high : 8; } part;
    struct { unsigned char sign : 1, rest : 7; } byte[4];
    unsigned char bytes[4];
};

struct packet { unsigned type : 4; unsigned length : 12; unsigned char body[2]; };

static struct packet packet(int type, int length)
{
    struct packet p = { type, length, { type + 1, length / 2 } };
    return p;
}

static unsigned sum(struct packet p) { return p.type + p.length + p.body[0] + p.body[1]; }

int main(void)
{
    union word w = { .all = 0x12345678 };
    struct packet packets[3], *p = packets;
    union { double d; struct { unsigned low; unsigned high : 20, exponent : 11, sign : 1; } bits; } u;

    printf("%x %x %x\n", w.part.low, w.part.middle, w.part.high);
    w.part.middle = 0xabcd;
    w.byte[3].sign = 1;
    w.byte[0].rest ^= 0x7f;
    printf("%08x %02x %02x\n", w.all, w.bytes[0], w.bytes[3]);
    for (int i = 0; i < 3; i++)
        packets[i] = packet(i + 5, i * 1000);
    printf("%u %u %u\n", sum(packets[0]), sum(packets[1]), sum(*(p + 2)));
    (p++)->type = 31;
    p->length--;
    printf("%d %d %u\n", packets[0].type, packets[1].length, (unsigned) sizeof packets);
    u.d = -6.5;
    printf("%u %d %x %u\n", u.bits.sign, u.bits.exponent - 1023, u.bits.high, u.bits.low);
    u.bits.exponent++;
    u.bits.sign = 0;
    printf("%g\n", u.d);
    struct packet copy;
    memcpy(&copy, p, sizeof copy);
    printf("%d\n", copy.length == p->length && copy.type == p->type);
    return 0;
}
