/* Combinations of type specifiers that mean nothing. */
long char a; // error: 'long char' is not a type
unsigned double b; // error: 'unsigned double' is not a type
short long c; // error: 'short long' is not a type
signed unsigned d; // error: 'signed unsigned' is not a type
long long long e; // error: 'long long long' is not a type
int float f; // error: 'int float' is not a type

int main(void)
{
    return 0;
}
