/* Programs of old compare addresses of different objects: an allocator whose list of free blocks
   is in the order of addresses (after Kernighan and Ritchie, 8.7), a copy whose direction depends on
   the order, and the question whether a pointer is into a pool. */
#include <stdio.h>
#include <string.h>

typedef union header {
    struct {
        union header *next;
        unsigned size;
    } s;
    long align;
} Header;

static Header base, *free_list;
static char arena[4096], *arena_end = arena;

static void release(void *block)
{
    Header *p = (Header *) block - 1, *q;

    for (q = free_list; !(p > q && p < q->s.next); q = q->s.next)
        if (q >= q->s.next && (p > q || p < q->s.next))
            break;
    if (p + p->s.size == q->s.next) {
        p->s.size += q->s.next->s.size;
        p->s.next = q->s.next->s.next;
    } else
        p->s.next = q->s.next;
    if (q + q->s.size == p) {
        q->s.size += p->s.size;
        q->s.next = p->s.next;
    } else
        q->s.next = p;
    free_list = q;
}

static int more(unsigned units)
{
    Header *p = (Header *) arena_end;

    units = (units + 63) / 64 * 64;
    if (units * sizeof(Header) > (unsigned) (arena + sizeof arena - arena_end))
        return 0;
    arena_end += units * sizeof(Header);
    p->s.size = units;
    release(p + 1);
    return 1;
}

static void *allocate(unsigned bytes)
{
    unsigned units = (bytes + sizeof(Header) - 1) / sizeof(Header) + 1;
    Header *p, *previous = free_list;

    if (previous == NULL) {
        base.s.next = free_list = previous = &base;
        base.s.size = 0;
    }
    for (p = previous->s.next;; previous = p, p = p->s.next) {
        if (p->s.size >= units) {
            if (p->s.size == units)
                previous->s.next = p->s.next;
            else {
                p->s.size -= units;
                p += p->s.size;
                p->s.size = units;
            }
            free_list = previous;
            return p + 1;
        }
        if (p == free_list) {
            if (!more(units))
                return NULL;
            p = free_list;
        }
    }
}

static void move(char *to, const char *from, int count)
{
    if (to < from)
        while (count-- > 0)
            *to++ = *from++;
    else
        while (count-- > 0)
            to[count] = from[count];
}

static int in_arena(const void *p)
{
    return (const char *) p >= arena && (const char *) p < arena + sizeof arena;
}

int main(void)
{
    char *blocks[20], text[] = "moved within", other[16] = "";
    int i, count = 0;
    Header *p;

    for (i = 0; i < 20; i++) {
        blocks[i] = allocate(20 + 3 * i);
        sprintf(blocks[i], "block %d", i);
    }
    for (i = 0; i < 20; i += 3)
        release(blocks[i]);
    for (i = 1; i < 20; i += 3)
        printf("%s %d\n", blocks[i], in_arena(blocks[i]));
    for (i = 1; i < 20; i += 3)
        release(blocks[i]);
    for (p = base.s.next; p != &base; p = p->s.next)
        count++;
    printf("%d free, %d used, %d\n", count, (int) (arena_end - arena), allocate(5000) == NULL);
    move(text + 2, text, 6);
    move(other, text, 13);
    printf("%s %s %d\n", text, other, in_arena(other));
    return 0;
}
