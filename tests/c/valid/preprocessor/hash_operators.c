/* # turns an argument into a string, as it was spelled; ## concatenates tokens (C17 6.10.3.2, 6.10.3.3). */
#include <stdio.h>

#define STRING(x) #x
#define EXPANDED(x) STRING(x)
#define JOIN(a, b) a##b
#define JOIN_EXPANDED(a, b) JOIN(a, b)
#define THREE(a, b, c) a##b##c
#define ONE 1
#define VALUE_1 "value one"
#define EMPTY
#define hash_hash # ## #
#define CASE(n) case JOIN(KIND_, n): return STRING(n)
#define FIELD(type, name) type JOIN(m_, name)

enum { KIND_RED, KIND_BLUE };
struct s { FIELD(int, x); FIELD(char *, y); };

static const char *kind(int k)
{
    switch (k) {
        CASE(RED);
        CASE(BLUE);
    }
    return "?";
}

int main(void)
{
    int xy = 5, x1 = 6, JOIN(un, named) = 7;
    struct s s = { .m_x = 8, .m_y = STRING(nine) };

    puts(STRING(a  +   b));
    puts(STRING( "quoted\n" '\0' ));
    puts(STRING(ONE) EXPANDED(ONE));
    puts(STRING());
    puts(EXPANDED(EMPTY));
    puts(STRING((a, b)));
    printf("%d %d %d\n", JOIN(x, y), JOIN(x, 1), unnamed);
    puts(JOIN_EXPANDED(VALUE_, ONE));
    printf("%d %d\n", JOIN(1, 2), JOIN(, 3));
    printf("%g\n", THREE(1, ., 5));
    printf("%d\n", 4 JOIN(<, <) 2 JOIN(,) + JOIN(-, ) 1);
    puts(EXPANDED(hash_hash));
    printf("%s %s %d %s\n", kind(KIND_RED), kind(KIND_BLUE), s.m_x, s.m_y);
    return 0;
}
