/* Declarations without their semicolons, before a line that would otherwise belong to them. */
struct cell { int x; } // error: expected ';' after '}'
//                    ^
struct map { int y; };
enum heading { NORTH, SOUTH } // error: expected ';' after '}'
static const struct map home = { 3 };
typedef struct { int x; } place // error: expected ';' after 'place'
//                             ^
static place here;
typedef int inches // error: expected ';' after 'inches'
inches far(inches); // an `int`, which the line before must have declared
int count // error: expected ';' after 'count'
struct map other;
void turn(int angle) // error: expected ';' after ')'
//                  ^
int main(void)
{
    struct local { int z; } // error: expected ';' after '}'
    int i = far(here.x) + NORTH + home.y;
    turn(i + count + other.y);
    return 0;
}
