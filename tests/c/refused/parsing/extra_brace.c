/* One brace too many. */
int main(void)
{
    return 0;
}
} // error: expected a declaration before '}'
